/* UTF-8 (RFC 3629), a character at a time: no overlong forms, no surrogates, nothing beyond U+10FFFF. */
#include "io/file/utf8.h"

static bool is_more(char c) { return ((unsigned char)c & 0xc0) == 0x80; }

const char *wcut_utf8_next(const char *text, uint32_t *code) {
    static const uint32_t min[5] = {0, 0, 0x80, 0x800, 0x10000};
    const unsigned char c = (unsigned char)text[0];
    const int length = c < 0x80 ? 1 : c >= 0xf0 ? 4 : c >= 0xe0 ? 3 : 2;
    uint32_t value = length == 1 ? c : c & (0x7fu >> length);
    bool ok = c < 0x80 || (c >= 0xc2 && c < 0xf5);
    for (int k = 1; ok && k < length; k++) { /* a zero byte is none of these: never beyond the end */
        ok = is_more(text[k]);
        value = value << 6 | ((unsigned char)text[k] & 0x3fu);
    }
    ok = ok && value >= min[length] && value <= 0x10ffff && !(value >= 0xd800 && value < 0xe000);
    *code = ok ? value : 0xfffd;
    return text + (ok ? length : 1);
}

bool wcut_utf8_is_plain(const char *text) {
    while (*text) {
        uint32_t code;
        const char *behind = wcut_utf8_next(text, &code);
        const bool was_none = code == 0xfffd && (unsigned char)text[0] != 0xef;
        if (was_none || code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0xfffe || code == 0xffff) return false;
        text = behind;
    }
    return true;
}
