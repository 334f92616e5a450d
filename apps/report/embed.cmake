# Turn the committed bundle into a C source: cmake -DFOLDER=apps/report/dist -DOUT=report_bundle.c -P embed.cmake
function(append_bytes file name)
  file(READ ${file} hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
  file(APPEND ${OUT}.new "const unsigned char ${name}[] = {\n${hex}};\nconst size_t ${name}_size = ${size};\n")
endfunction()

file(WRITE ${OUT}.new "/* Made from apps/report/dist by apps/report/embed.cmake. */\n#include <stddef.h>\n\n"
     "extern const unsigned char wcut_report_script[], wcut_report_style[];\n"
     "extern const size_t wcut_report_script_size, wcut_report_style_size;\n")
append_bytes(${FOLDER}/page.js wcut_report_script)
append_bytes(${FOLDER}/page.css wcut_report_style)
file(RENAME ${OUT}.new ${OUT})
