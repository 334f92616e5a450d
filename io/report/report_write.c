/* The report page: one HTML file whose policy runs and shows only what was embedded at build time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "io/report/report_page.h"

/* text as HTML: it can end no element and no attribute */
static void put_write_escaped(wcut_text *out, const char *text) {
    for (; *text; text++) {
        const char *as = *text == '<'    ? "&lt;"
                         : *text == '>'  ? "&gt;"
                         : *text == '&'  ? "&amp;"
                         : *text == '"'  ? "&quot;"
                         : *text == '\'' ? "&#39;"
                                         : NULL;
        wcut_text_put(out, as ? as : text, as ? strlen(as) : 1);
    }
}

static void put_word(wcut_text *out, const char *text) { wcut_text_put(out, text, strlen(text)); }

static void put_base64(wcut_text *out, size_t size, const void *data) {
    enum { PIECE = 3 * (WCUT_TEXT_ROOM / 4) };
    for (size_t at = 0; at < size; at += PIECE) {
        const size_t piece = size - at < PIECE ? size - at : PIECE;
        wcut_base64_print(piece, (const char *)data + at, wcut_text_room(out));
        out->count += (piece + 2) / 3 * 4;
    }
}

/* 'sha256-...' of what stands between the tags (Content Security Policy 3, 2.3.1) */
static void put_pin(wcut_text *out, size_t size, const void *data) {
    wcut_sha256 hash;
    uint8_t digest[WCUT_SHA256_SIZE];
    wcut_sha256_begin(&hash);
    wcut_sha256_add(&hash, data, size);
    wcut_sha256_end(&hash, digest);
    put_word(out, "'sha256-");
    put_base64(out, sizeof digest, digest);
    put_word(out, "'");
}

/* JSON that is safe in a script element: what could end the element stands as \u003c and its like. The dump is ASCII,
   and these letters stand in its strings alone. */
static int put_page_json(const char *text, size_t size, void *context) {
    wcut_text *out = context;
    for (size_t i = 0; i < size; i++) {
        if (text[i] == '<' || text[i] == '>' || text[i] == '&')
            wcut_text_print(out, "\\u%04x", (unsigned)text[i]);
        else
            wcut_text_put(out, text + i, 1);
    }
    return 0;
}

/* the words without a script: title and verdict */
static wcut_status put_page_head(wcut_text *out, const wcut_report *report) {
    /* texts for HTML: valid UTF-8, so that they cannot break the page */
    char *title = wcut_report_text(report->title), *verdict = wcut_report_text(report->verdict);
    char *verb = wcut_report_text(report->verb);
    const bool complete = title && verdict && verb;
    if (complete) {
        /* scripts and styles are pinned by their hashes: nothing that a text smuggles in can run */
        put_word(out,
                 "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                 "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src ");
        put_pin(out, wcut_report_script_size, wcut_report_script);
        put_word(out, "; style-src ");
        put_pin(out, wcut_report_style_size, wcut_report_style);
        put_word(out,
                 "; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n"
                 "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                 "<meta name=\"color-scheme\" content=\"light dark\">\n"
                 "<meta name=\"generator\" content=\"wirecut " WCUT_VERSION "\">\n<title>");

        put_write_escaped(out, title);
        put_word(out, " \xe2\x80\x93 wirecut ");
        put_write_escaped(out, verb);
        put_word(out, "</title>\n<style>");
        wcut_text_put(out, wcut_report_style, wcut_report_style_size);

        /* what a browser without scripts shows too */
        put_word(out, "</style>\n</head>\n<body>\n<main id=\"page\">\n<header>\n<p class=\"verb\">wirecut ");
        put_write_escaped(out, verb);
        put_word(out, "</p>\n<h1>");
        put_write_escaped(out, title);
        put_word(out, "</h1>\n<p class=\"verdict\">");
        put_write_escaped(out, verdict);
        put_word(out,
                 "</p>\n</header>\n<noscript><p>View, charts and tables need JavaScript, which this browser has "
                 "switched off.</p></noscript>\n</main>\n");
    }

    /* texts were copies */
    free(title);
    free(verdict);
    free(verb);
    return complete ? WCUT_OK : WCUT_NO_MEMORY;
}

static wcut_status put_page(wcut_text *out, const wcut_report *report, const json_t *document,
                            const wcut_report_pool *pool) {
    const wcut_status status = put_page_head(out, report);
    if (status) return status;
    put_word(out, "<script type=\"application/json\" id=\"report\">");
    if (json_dump_callback(document, put_page_json, out, JSON_COMPACT | JSON_ENSURE_ASCII)) return WCUT_NO_MEMORY;
    put_word(out, "</script>\n");
    for (int k = 0; k < pool->count; k++) {
        wcut_text_print(out, "<script type=\"text/plain\" id=\"array-%d\">", k);
        put_base64(out, pool->array[k].size, pool->array[k].data);
        put_word(out, "</script>\n");
    }
    put_word(out, "<script>");
    wcut_text_put(out, wcut_report_script, wcut_report_script_size);
    put_word(out, "</script>\n</body>\n</html>\n");
    return WCUT_OK;
}

static int count_bytes(const char *text, size_t size, void *context) {
    for (size_t i = 0; i < size; i++) *(size_t *)context += text[i] == '<' || text[i] == '>' || text[i] == '&' ? 6 : 1;
    return 0;
}

/* the page's size but for its head */
static wcut_status check_size(const json_t *document, const wcut_report_pool *pool, wcut_error *error) {
    size_t size = wcut_report_script_size + wcut_report_style_size + pool->size + 64 * (size_t)pool->count + 8192;
    if (json_dump_callback(document, count_bytes, &size, JSON_COMPACT | JSON_ENSURE_ASCII)) return WCUT_NO_MEMORY;
    if (size <= WCUT_REPORT_BYTES) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "report: %.1f MB of data, expected at most %.0f MB", (double)size / 1e6,
                     WCUT_REPORT_BYTES / 1e6);
}

wcut_status wcut_report_write(const wcut_report *report, const char *path, wcut_error *error) {
    /* the report is checked before anything is written */
    wcut_status status = wcut_report_check(report, error);
    if (status) return status;
    if (!path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "report: no path");

    /* the document and its arrays, then the page around them */
    wcut_report_pool pool = {0};
    wcut_file *file = NULL;
    wcut_text out = {0};
    json_t *document = wcut_report_json(report, &pool);
    status = document ? check_size(document, &pool, error) : WCUT_NO_MEMORY;
    if (!status) status = wcut_file_create(path, &file, error);
    if (!status) status = wcut_text_create(&out, file) ? put_page(&out, report, document, &pool) : WCUT_NO_MEMORY;

    /* the file takes its name only now */
    if (!status) {
        wcut_text_flush(&out);
        status = wcut_file_commit(file, error);
    }
    if (status == WCUT_NO_MEMORY) wcut_fail(error, status, "report: %s", wcut_status_text(status));

    wcut_text_destroy(&out);
    wcut_file_destroy(file);
    json_decref(document);
    wcut_report_pool_clear(&pool);

    return status;
}
