# $line = 12
place-line = line { $line }

# $row = 12
place-row = row { $row }

# $column = "X"
place-column = column { $column }

# $of = "control"
# $latitude = 48.2
# $longitude = 16.37
# $latitude_deg = 48.2
# $longitude_deg = 16.37
# $north = "N"
# $east = "E"
place-of_block = Place of the { $of ->
     [control] control
     *[positions] positions
    }: { NUM($latitude_deg, decimals: 4) }° { $north }, { NUM($longitude_deg, decimals: 4) }° { $east } (WGS 84).
