# $detail = "Invalid value (character 7)"
toml-invalid = This is not valid TOML: { $detail }.
    .do = Correct this line.
