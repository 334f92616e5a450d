"""terminal.py [--interrupt SIGNAL] [--after N] [--environment NAME=VALUE]... COMMAND...: a command with a terminal as
standard error.

What it says there goes to the file `terminal`, its standard output to `out`. With --interrupt the signal is sent as
soon as progress is seen, or as it has come to N with --after (-N: to N steps before the last). Ends with the command's exit code, 128 + n where it died of signal n.
"""
import os
import pty
import re
import signal
import subprocess
import sys

arguments, interrupt, after, environment = sys.argv[1:], None, 0, dict(os.environ, TERM="xterm")
environment.pop("NO_COLOR", None)
while arguments[0].startswith("--"):
    if arguments[0] == "--interrupt":
        interrupt = getattr(signal, arguments[1])
    elif arguments[0] == "--after":
        after = int(arguments[1])
    else:
        name, value = arguments[1].split("=", 1)
        environment[name] = value
    arguments = arguments[2:]

if interrupt:  # heard also where whoever runs this had it ignored, as a shell does in the background
    signal.signal(interrupt, signal.SIG_DFL)
master, slave = pty.openpty()
with open("out", "wb") as out:
    process = subprocess.Popen(arguments, stdin=slave, stdout=out, stderr=slave, env=environment)
os.close(slave)
said = b""
while True:
    try:
        read = os.read(master, 4096)
    except OSError:  # the terminal's other side is closed
        break
    if not read:
        break
    said += read
    steps = re.findall(rb"\] (\d+)/(\d+) st", said)
    if interrupt and any(int(at) >= (after if after >= 0 else int(end) + after) for at, end in steps):
        process.send_signal(interrupt)
        interrupt = None
with open("terminal", "wb") as file:
    file.write(said)
code = process.wait()
sys.exit(code if code >= 0 else 128 - code)
