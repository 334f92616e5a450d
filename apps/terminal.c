/* Lines that any terminal can take, and a bar that only a terminal gets. */
#include "terminal.h"

#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "command.h"

enum {
    LINE_MAX_BYTES = 6000, /* a path of PATH_MAX and a library's error text */
    ESCAPE_MAX = 10,       /* "\U0010FFFF" and its end */
    BAR_WIDTH = 30,
    BAR_WORDS = 46, /* "[] 1000000/1000000 stations 100 % 100000 s left" */
    WIDTH_MIN = 40
};
#define REDRAW_S 0.1 /* more often only flickers */

static volatile sig_atomic_t interrupted;

/* ---- escaping ---- */

/* Length of the UTF-8 sequence at text and its code point; 0 where it is none (RFC 3629). */
static int decode(const unsigned char *text, uint32_t *code) {
    static const uint32_t min[] = {0, 0, 0x80, 0x800, 0x10000};
    int length = text[0] < 0x80 ? 1 : text[0] >> 5 == 6 ? 2 : text[0] >> 4 == 14 ? 3 : text[0] >> 3 == 30 ? 4 : 0;
    if (length == 0) return 0;
    uint32_t c = length == 1 ? text[0] : text[0] & (0x7fu >> length);
    for (int i = 1; i < length; i++) {
        if (text[i] >> 6 != 2) return 0;
        c = c << 6 | (text[i] & 0x3fu);
    }
    if (c < min[length] || c > 0x10ffff || (c >= 0xd800 && c <= 0xdfff)) return 0;
    *code = c;
    return length;
}

/* Controls, line separators and what turns the reading direction: a name may not move the cursor or dress up as
   another. */
static bool is_unprintable(uint32_t c) {
    return c < 0x20 || (c >= 0x7f && c <= 0x9f) || c == 0x200e || c == 0x200f || (c >= 0x2028 && c <= 0x202e) ||
           (c >= 0x2066 && c <= 0x2069) || c == 0xfeff;
}

static void escape(const char *text, char *line, size_t size) {
    const unsigned char *from = (const unsigned char *)text;
    char *to = line, *end = line + size - ESCAPE_MAX;
    while (*from && to < end) {
        uint32_t code = 0;
        int length = decode(from, &code);
        if (length == 0)
            to += sprintf(to, "\\x%02x", *from++);
        else if (is_unprintable(code))
            to += sprintf(to, code < 0x80 ? "\\x%02x" : "\\u%04x", (unsigned)code), from += length;
        else
            for (int i = 0; i < length; i++) *to++ = (char)*from++;
    }
    *to = 0;
}

/* ---- lines ---- */

static void put_terminal_line(const char *prefix, const char *format, va_list arguments) {
    char text[LINE_MAX_BYTES], line[LINE_MAX_BYTES];
    vsnprintf(text, sizeof text, format, arguments);
    escape(text, line, sizeof line);
    fprintf(stderr, "%s%s\n", prefix, line);
}

void app_say(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    put_terminal_line("", format, arguments);
    va_end(arguments);
}

int app_fail(int code, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    put_terminal_line("wirecut: ", format, arguments);
    va_end(arguments);
    return code;
}

int app_exit_code(wcut_status status) {
    switch (status) {
        case WCUT_OK:
            return APP_DONE;
        case WCUT_BAD_ARGUMENT:
        case WCUT_DEGENERATE:
        case WCUT_NOT_FOUND:
        case WCUT_BAD_FORMAT:
            return APP_BAD_INPUT;
        case WCUT_NOT_WRITTEN:
            return APP_NOT_WRITTEN;
        case WCUT_NOT_CONVERGED:
            return APP_NOT_CONVERGED;
        case WCUT_INTERRUPTED:
            return APP_INTERRUPTED;
        default:
            return APP_FAILED;
    }
}

int app_fail_status(wcut_status status, const char *place, const wcut_error *error) {
    const char *text = error && error->text[0] ? error->text : wcut_status_text(status);
    return app_fail(app_exit_code(status), "%s%s%s", place ? place : "", place ? ": " : "", text);
}

/* ---- interruption ---- */

static void on_signal(int number) {
    (void)number;
    interrupted = 1;
}

/* A signal that whoever called us had ignored stays ignored: a job in the background of a script. */
static void catch_signal(int number) {
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = (int)SA_RESETHAND}, before;
    sigemptyset(&action.sa_mask);
    if (sigaction(number, NULL, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(number, &action, NULL);
}

void app_catch_interrupts(void) {
    catch_signal(SIGINT);
    catch_signal(SIGTERM);
}

bool app_is_interrupted(void) { return interrupted; }

/* ---- progress ---- */

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int app_terminal_width(int fd, int without) {
    struct winsize size;
    if (!isatty(fd) || ioctl(fd, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return without;
    return size.ws_col < WIDTH_MIN ? WIDTH_MIN : size.ws_col;
}

app_progress app_progress_begin(bool quiet) {
    const char *terminal = getenv("TERM"), *no_color = getenv("NO_COLOR");
    bool plain = (no_color && *no_color) || !terminal || !*terminal || strcmp(terminal, "dumb") == 0;
    return (app_progress){.visible = !quiet && !plain && isatty(STDERR_FILENO), .begun = seconds(), .unit = "stations"};
}

int app_progress_step(int station, int stations, void *context) {
    app_progress *p = context;
    double now = seconds();
    if (p->visible && stations > 0 && now - p->drawn >= REDRAW_S) {
        double done = (double)(station + 1) / stations, left = (now - p->begun) * (1 - done) / done;

        /* a line that is broken by a narrow terminal cannot be drawn over */
        char bar[BAR_WIDTH + 1];
        const int room = app_terminal_width(STDERR_FILENO, BAR_WIDTH + BAR_WORDS) - BAR_WORDS;
        const int width = room < BAR_WIDTH ? room > 0 ? room : 0 : BAR_WIDTH;
        for (int i = 0; i < width; i++) bar[i] = i < done * width ? '#' : '.';
        bar[width] = 0;
        fprintf(stderr, "\r[%s] %d/%d %s %3.0f %% %.0f s left\033[K", bar, station + 1, stations, p->unit, 100 * done,
                left);
        p->drawn = now;
    }
    return app_is_interrupted();
}

void app_progress_end(app_progress *progress) {
    if (progress->visible && progress->drawn > 0) fputs("\r\033[K", stderr);
    progress->visible = false;
}
