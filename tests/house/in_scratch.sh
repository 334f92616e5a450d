# Run a command in an empty folder of its own:  in_scratch.sh FOLDER COMMAND ARGUMENT...
set -eu
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
exec "$@"
