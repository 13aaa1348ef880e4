# $detail = "Invalid value (character 7)"
toml-invalid = This is not valid TOML: { $detail }.
    .do = Correct this line.

# $first = "position_fixes"
# $second = "position_pieces"
toml-keys_exclude = { $first } and { $second } exclude each other.
    .do = Delete one of them.

# $name = "'lenght_unit'"
# $known = ["name", "length_unit"]
toml-unknown_key = Key { $name } is unknown.
    .do = Use one of { LIST($known, most: 24) }, or delete it.
