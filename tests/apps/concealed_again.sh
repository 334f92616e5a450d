# The sealed cases are what their generator makes: the same answers, the same jobs and recordings but for their last digit.
#   concealed_again.sh MAKE        labels: sample
set -eu
concealed=$SOURCE_DIR/samples/concealed
"$1" again
for name in one two three; do
    base64 -d "$concealed/answers/$name.sealed" >opened
    cmp -s opened "again/answers/$name.json" || { echo "$name: another answer"; exit 1; }
    hash=$(sha256sum opened | cut -d ' ' -f 1)
    grep -q "$name.*$hash" "$concealed/README.md" || { echo "$name: README.md has another hash than $hash"; exit 1; }
done
python3 - "$concealed" again <<'EOF'
import os, re, sys
number = re.compile(r"-?\d+\.?\d*(?:e[-+]?\d+)?")
compared = 0
for name in ("one", "two", "three"):
    for folder, _, files in os.walk(os.path.join(sys.argv[1], name)):
        for file in files:
            here = os.path.join(folder, file)
            there = os.path.join(sys.argv[2], os.path.relpath(here, sys.argv[1]))
            a, b = open(here).read(), open(there).read()
            assert number.sub("#", a) == number.sub("#", b), here
            # the loop repeats itself to 1e-9; files have four digits, and a digit may fall either way
            far = max(abs(float(x) - float(y)) for x, y in zip(number.findall(a), number.findall(b)))
            assert far <= 0.011, (here, far)
            compared += 1
assert compared == 3 * 12, compared
EOF
