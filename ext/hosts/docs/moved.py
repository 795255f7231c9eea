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
    "sql_reference": "reference/index",
    "storage_format": "developers/storage_format",
    "unexpected": "faq",
    "watches": "explanation/watches",
}
ANCHORS = {
    "avoidance": {
        "how-it-is-proven": "explanation/avoidance#proof",
        "what-is-promised": "explanation/avoidance#guarantees",
        "whole-traffic-at-once": "how-to/clear_traffic",
    },
    "accuracy": {
        "how-to-attack-it": "explanation/accuracy#objections",
        "the-methods": "explanation/accuracy#methods",
        "the-pictures": "explanation/accuracy#charts",
        "what-goes-wrong-elsewhere": "explanation/accuracy#errors-of-other-methods",
        "what-to-trust": "explanation/accuracy#results",
    },
    "benchmarks": {
        "the-goals-one-by-one": "developers/benchmarks#goals",
        "what-agrees-with-the-paper-and-what-does-not": "developers/benchmarks#agreement-with-the-paper",
    },
    "scale_dask": {
        "in-three-commands": "how-to/tiles_on_dask#three-commands",
        "several-machines-and-who-may-run-what": "how-to/tiles_on_dask#several-machines-security",
        "what-is-in-the-folder": "how-to/tiles_on_dask#the-folder",
        "what-it-costs": "how-to/tiles_on_dask#cost",
        "what-may-go-wrong": "how-to/tiles_on_dask#errors",
    },
    "gpcd": {
        "what-is-kept": "explanation/gpcd#guarantees",
        "who-does-it": "explanation/gpcd#files-of-the-steps",
    },
    "semantics": {
        "answers": "explanation/semantics#determinism",
        "moments": "explanation/semantics#time",
    },
    "geography": {
        "a-port-a-coast-the-plane": "how-to/latitude_and_longitude#plane-for-a-port-or-a-coast",
        "all-the-earth-the-globe": "how-to/latitude_and_longitude#globe-for-the-whole-earth",
    },
    "recipes": {
        "watch-zones-find-the-nearest-depot": "how-to/geofences",
    },
    "scale": {
        "by-a-shell-loop": "how-to/many_files#a-shell-loop",
        "the-rule-and-why-it-is-right": "explanation/tiles#rule",
        "what-they-do-not-do": "how-to/many_files#pitfalls",
        "what-tiles-cost": "how-to/many_files#cost",
        "which-size-needs-what": "how-to/many_files",
    },
    "shapes": {
        "an-airspace": "how-to/zones_from_geojson#an-airspace",
        "meshes-of-other-systems": "how-to/meshes",
        "texts-of-other-systems": "how-to/zones_from_geojson#numbers",
        "zones-from-geojson": "how-to/zones_from_geojson",
    },
    "sql_reference": {
        "columns": "reference/moving_objects#columns",
        "commands": "reference/moving_objects#commands",
        "reading-and-writing": "reference/moving_objects#reading-and-writing",
        "values": "reference/moving_objects#values",
        "geography": "reference/geo_to_plane",
        "growth": "reference/growth",
        "joined-to-other-tables": "reference/query_planner",
        "loading": "reference/loading",
        "meshes": "reference/shape#meshes",
        "outlines": "reference/shape#outlines",
        "predictive_avoid": "reference/predictive_avoid",
        "predictive_changes": "reference/predictive_changes",
        "predictive_explain": "reference/predictive_explain",
        "predictive_join": "reference/predictive_join",
        "predictive_nearest": "reference/predictive_nearest",
        "predictive_position": "reference/predictive_position",
        "predictive_sweep": "reference/predictive_sweep",
        "predictive_track": "reference/predictive_track",
        "predictive_watch": "reference/predictive_watch",
        "predictive_watches": "reference/predictive_watches",
        "predictive_window": "reference/predictive_window",
        "scalar-functions": "reference/foresee_version",
        "the-table-moving_objects": "reference/moving_objects",
        "tiles": "reference/predictive_join#tiles",
        "what-is-noticed-of-tampering": "reference/integrity",
    },
    "unexpected": {
        "after-dump-and-read-no-such-table": "faq#why-is-a-table-missing-after-dump-and-read",
        "no-rows-an-input-by-its-name": "faq#why-does-a-query-return-no-rows-when-i-pass-an-input-by-name",
        "no-such-module-moving_objects": "faq#why-does-sqlite-say-no-such-module-moving_objects",
        "the-wrong-order-of-magnitude-units": "faq#why-are-the-distances-wrong-by-orders-of-magnitude",
        "too-few-rows-now-is-later-than-it-seems": "faq#why-are-there-too-few-rows",
        "too-many-rows-ships-that-went-silent": "faq#why-do-ships-that-have-gone-silent-still-appear",
    },
    "watches": {
        "a-live-feed": "how-to/follow_a_watch#a-live-feed",
        "a-reader-that-remembers-its-position": "how-to/follow_a_watch#a-reader-that-remembers-its-position",
        "commands-and-options": "reference/predictive_watch#inputs",
        "the-clock": "explanation/watches#clock",
        "two-levels": "how-to/follow_a_watch#two-levels",
        "what-a-change-is": "explanation/watches#definition-of-a-change",
        "what-changed": "explanation/watches#changes",
        "what-it-costs": "explanation/watches#cost",
        "when-something-is-wrong": "explanation/watches#faults",
        "without-the-extension": "how-to/follow_a_watch#without-the-extension",
    },
}

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
