# Names of the WCUT_API functions of public headers, one a line:  cat HEADERS | awk -f declared.awk
# A declaration may run over several lines: all is read as one text, comments taken out.
{ text = text " " $0 }
END {
    while (match(text, /\/\*([^*]|\*+[^*\/])*\*+\//)) text = substr(text, 1, RSTART - 1) " " substr(text, RSTART + RLENGTH)
    while (match(text, /WCUT_API[^;({]*[ *]wcut_[a-z0-9_]+ *\(/)) {
        declaration = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        sub(/ *\($/, "", declaration)
        sub(/.*[ *]/, "", declaration)
        print declaration
    }
}
