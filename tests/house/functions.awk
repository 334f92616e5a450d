# One line for every C function of the files given:  awk -f functions.awk FILE...
#   FILE LINE NAME LINES COMMENTS BLANKS STATIC ABOVE
# LINES from its name to its closing brace, COMMENTS that begin inside it, lines of BLANKS inside it, STATIC 1 or 0, ABOVE 1
# where a comment stands right above it. Reads what clang-format writes: a function begins and ends in the first column.

function begins(text) { return text ~ /^[A-Za-z_].*\(/ && text !~ /;[ \t]*$/ && text !~ /^(typedef|extern "C"|#)/ && text !~ /= *\{/ }

# the word before the first parenthesis that is not of an attribute
function name_of(text, name) {
    if (match(text, /^(TEST|TEST_EACH|START_TEST)\([a-z0-9_]+/)) {
        name = substr(text, RSTART, RLENGTH)
        sub(/.*\(/, "", name)
        return name
    }
    gsub(/__attribute__\(\([^)]*\)\)/, "", text)
    sub(/\(.*/, "", text)
    sub(/[ \t]+$/, "", text)
    sub(/.*[ *\t]/, "", text)
    return text
}

function comments_of(text, count) {
    gsub(/"([^"\\]|\\.)*"/, "", text)
    count = gsub(/\/\*/, "", text)
    count += gsub(/(^|[^:])\/\//, "", text)
    return count
}

FNR == 1 { inside = 0; head = 0; above = 0; after_comment = 0 }

!inside && !head && begins($0) {
    head = 1
    first = FNR
    name = name_of($0)
    is_static = $0 ~ /^static / || $0 ~ /^(TEST|TEST_EACH|START_TEST)\(/
    comments = blanks = 0
    above = after_comment
}
head && !inside {
    if ($0 ~ /;[ \t]*$/ && $0 !~ /\{/) head = 0 # a declaration
    else if ($0 ~ /\{.*\}[ \t]*$/) { print FILENAME, first, name, FNR - first + 1, comments_of($0), 0, is_static, above; head = 0 }
    else if ($0 ~ /\{[ \t]*(\/\*.*\*\/)?[ \t]*$/) { inside = 1; comments += comments_of($0) }
    after_comment = 0
    next
}
inside {
    comments += comments_of($0)
    if ($0 ~ /^[ \t]*$/) blanks++
    if ($0 ~ /^\}/) {
        print FILENAME, first, name, FNR - first + 1, comments, blanks, is_static, above
        inside = head = 0
    }
    after_comment = 0
    next
}
{ after_comment = $0 ~ /\*\/[ \t]*$/ || $0 ~ /^[ \t]*\/\// }
