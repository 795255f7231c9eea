"""Pages that have moved, so that old addresses of the site still lead to them.

    pages = redirects()      # {"sql_reference.html": the text of a page that leads on}

MOVED names the new page of each old one. Where a page was split, ANCHORS names the page of a heading. Addresses are as on the site,
without a suffix; a heading that ANCHORS does not name is looked for on the new page.
"""
import json
import posixpath

MOVED = {
    "accuracy": "explanation/accuracy",
    "architecture": "developers/architecture",
    "avoidance": "explanation/avoidance",
    "benchmarks": "developers/benchmarks",
    "exactness": "explanation/exactness",
    "geography": "how-to/latitude_and_longitude",
    "gpcd": "explanation/gpcd",
    "pictures": "how-to/maps_and_pictures",
    "recipes": "developers/recipes",
    "scale": "how-to/many_files",
    "scale_dask": "how-to/tiles_on_dask",
    "semantics": "explanation/semantics",
    "shapes": "how-to/hulls",
    "sql_reference": "reference/moving_objects",
    "storage_format": "developers/storage_format",
    "unexpected": "faq",
    "watches": "explanation/watches",
}
ANCHORS = {}

PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<title>Moved</title>
<link rel="canonical" href="{target}">
<noscript><meta http-equiv="refresh" content="0; url={target}"></noscript>
<p>This page has moved to <a href="{target}">{target}</a>.</p>
<script>
var moved = {anchors}, heading = location.hash.slice(1);
location.replace(Object.hasOwn(moved, heading) ? moved[heading] : "{target}" + location.hash);
</script>
</html>
"""


def redirects():
    """{file of the site: text of the page that leads to the new address}."""
    pages = {}
    for old, new in MOVED.items():
        here = posixpath.dirname(old)
        anchors = {heading: posixpath.relpath(page, here or ".") + ".html" + (sign and "#" + rest)
                   for heading, place in ANCHORS.get(old, {}).items() for page, sign, rest in [place.partition("#")]}
        target = posixpath.relpath(new, here or ".") + ".html"
        pages[old + ".html"] = PAGE.format(target=target, anchors=json.dumps(anchors))
    return pages
