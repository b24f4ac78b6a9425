#!/bin/sh
# Prints the lines with which a table begins that is measured here and now: table_head.sh NOTE
set -eu
echo "# commit: $(git -C "$(dirname "$0")" describe --always --dirty=+ --exclude='*' 2>/dev/null || echo unknown)"
echo "# machine: $(sed -n 's/^model name[^:]*: \(.*\)/\1/p' /proc/cpuinfo | head -n 1 | tr ',' ' ')"
echo "# compiler: $(c++ --version | sed -n '1s/^c++ .*) /g++ /p')"
echo "# date: $(date -u +%Y-%m-%d)"
echo "# note: $1"
