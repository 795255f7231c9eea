#!/usr/bin/env bash
# The docs site: a folder that opens from disk, build/packages/docs/index.html; its search needs a web server, of any kind
# (`python3 -m http.server -d build/packages/docs`).
#
#   bash ext/hosts/docs/build.sh [FOLDER]
#
# Installs mkdocs and its theme where they are missing (Debian). A link that leads nowhere is an error.
set -euo pipefail
cd "$(dirname "$0")/../../.."
. sql/packages.sh
need_packages "python3: command python3" "mkdocs: command mkdocs"
[ -d /usr/share/mkdocs/themes/material ] || install_with_apt mkdocs-material mkdocs-material-extensions

folder=$(realpath -m "${1:-build/packages/docs}")
/usr/bin/python3 ext/hosts/docs/stage.py build/docs_site
mkdocs build --quiet --strict --config-file build/docs_site/mkdocs.yml --site-dir "$folder"
echo "$folder/index.html"
