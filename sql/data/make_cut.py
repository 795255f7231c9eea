"""Makes new_york_20220103.csv from the reports of shared/data: New York Harbour, in the columns of NOAA's files.

    python3 sql/data/make_cut.py ../shared/data/ships_us_20220103.csv.gz sql/data/new_york_20220103.csv

Names are made up; IMO number, call sign, draught and cargo are blank, because the source does not have them. README.md has the rest.
"""
import csv
import gzip
import itertools
import random
import sys
from datetime import datetime, timezone

SOUTH, WEST, NORTH, EAST = 40.3, -74.4, 41.0, -73.6
HEADER = ["MMSI", "BaseDateTime", "LAT", "LON", "SOG", "COG", "Heading", "VesselName", "IMO", "CallSign", "VesselType", "Status",
          "Length", "Width", "Draft", "Cargo", "TransceiverClass"]
FIRST = "AMBER BRIGHT COASTAL EASTERN GOLDEN GRAND HUDSON IVORY JOLLY LITTLE LUCKY MERRY MORNING NORTHERN OCEAN QUIET ROYAL SILVER SWIFT WESTERN".split()
SECOND = "ANCHOR BEACON COMPASS CURLEW DOLPHIN EGRET GANNET HERON ISLANDER KESTREL LANTERN MARINER OSPREY PELICAN PETREL PLOVER RAMBLER TERN VOYAGER WILLET".split()


def made_up_names(ships):
    names = [" ".join(words) for words in itertools.product(FIRST, SECOND)]
    random.Random(20220103).shuffle(names)
    return dict(zip(ships, names))


def main():
    source, target = sys.argv[1:]
    with gzip.open(source, "rt", newline="") as file:
        reports = [row for row in csv.DictReader(file)
                   if SOUTH <= float(row["lat"]) <= NORTH and WEST <= float(row["lon"]) <= EAST]
    names = made_up_names(sorted({row["mmsi"] for row in reports}, key=int))
    with open(target, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for row in sorted(reports, key=lambda row: (int(row["t"]), int(row["mmsi"]))):
            time = datetime.fromtimestamp(int(row["t"]), timezone.utc).strftime("%Y-%m-%dT%H:%M:%S")
            writer.writerow([row["mmsi"], time, row["lat"], row["lon"], row["sog_kn"], row["cog_deg"], row["heading_deg"],
                             names[row["mmsi"]], "", "", row["vessel_type"], row["nav_status"], row["length_m"], row["width_m"], "", "",
                             row["ais_class"]])


if __name__ == "__main__":
    main()
