# $name = "'../one'"
dataset-name = { $name } is not a valid name of a data set.
    .do = Use letters, digits and hyphens: it also names a folder.

# $address = "'file:///etc/'"
dataset-address = { $address } is not the address of a folder.
    .do = Give http... with / at its end.

dataset-file_entry = A file of a data set needs three values.
    .do = Give [path, bytes, SHA-256].

# $path = "'../a.jpg'"
dataset-path_outside = { $path } leads out of the folder of the data set.
    .do = Give a path without .. and without / at its beginning.

# $value = "'00'"
dataset-no_sha256 = { $value } is not a SHA-256 checksum.
    .do = Give 64 digits 0 to f.

# $name = "caste"
# $known = ["castle", "sceaux"]
dataset-unknown = Data set { $name } is unknown.
    .do = Use one of { LIST($known, most: 40) }.

# $size_bytes = 1200
# $sha256 = "0123456789ab"
# $expected_bytes = 1300
# $expected_sha256 = "ba9876543210"
# $source = "https://example.org"
dataset-checksum = The file has { $size_bytes } bytes and checksum { $sha256 }; expected { $expected_bytes } and { $expected_sha256 }.
    .why = A proxy may have changed it.
    .do = Run the command again, or visit { $source }.

# $received_bytes = 1200
# $size_bytes = 13000
dataset-connection_ended = The connection ended after { $received_bytes } of { $size_bytes } bytes.
    .do = Run the command again; it continues there.

# $detail = "timed out"
dataset-connection_broken = The connection broke ({ $detail }).
    .do = Run the command again; it continues there.

# $status = "404"
# $detail = "Not Found"
# $busy = false
dataset-server_answer = The server answers { $status } { $detail }.
    .do = { $busy ->
        [yes] Try again later
       *[no] Check the address: the file may have moved
     }.

# $host = "example.org"
# $detail = "timed out"
dataset-no_connection = There is no connection to { $host } ({ $detail }).
    .do = Check the network (HTTPS_PROXY names a proxy), and run the command again; it continues there.

# $name = "truth"
dataset-incomplete = { $name } is missing; a set has photos, measured.csv and truth.
    .do = Create the set again.
