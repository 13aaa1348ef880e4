parquet-damaged = The Parquet file is damaged or incomplete.
    .do = Write it again.

parquet-column_lengths = The columns of the Parquet file differ in length.
    .do = Write it again.

# $n = 1000000000
# $size_bytes = 1200
parquet-too_many_rows = The Parquet file announces { $n } rows in { $size_bytes } bytes.
    .why = The file is damaged, or no table.
    .do = Write it again.

# $detail = "Couldn't deserialize thrift"
parquet-not_readable = The Parquet file cannot be read ({ $detail }).
    .do = Write it again.

parquet-no_footer = The file does not end like a Parquet file.
    .why = It is damaged, incomplete or of another format.
    .do = Write it again.

# $footer_bytes = 2000000
# $size_bytes = 1200
parquet-footer_too_large = The Parquet file announces a footer of { $footer_bytes } bytes; the file has { $size_bytes }.
    .do = Write it again.

# $type = "list<item: double>"
# $numbers = true
parquet-column_type = The column contains { $type }; { $numbers ->
        [yes] numbers
       *[no] texts
     } are needed.
    .do = Write the column with another type.

# $encoding = "DELTA_BYTE_ARRAY"
parquet-encoding = The column has the encoding { $encoding }, which is refused.
    .why = Its size in memory is not known before decoding.
    .do = Write it with another encoding.

# $n = 10000000
# $most = 4194304
# $size_bytes = 900000000
# $limit_bytes = 536870912
parquet-group_too_large = A row group has { $n } rows and { $size_bytes } bytes (limits { $most } and { $limit_bytes }).
    .do = Write the file with smaller row groups.
