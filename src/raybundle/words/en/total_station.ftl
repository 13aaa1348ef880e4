# $set = "S1"
# $station = "P1"
# $target = "T4"
total_station-vertical_sight = Set { $set } of directions.csv: { $station } and { $target } have the same plan position in points.csv.
    .why = A horizontal direction between them is undefined.
    .do = Correct their coordinates, or delete this direction.
