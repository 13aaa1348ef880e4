# $names = ["azimuths.csv"]
# $ids = ["azimuths.csv"]
tables_not_read = Tables in the block folder were not read: { LIST($names, most: 3) }.
    .why = Observations in them take no part.
    .do = Use a table name of the block format, or adjust in Python with the own kind of observation imported.
