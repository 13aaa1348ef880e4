toml-invalid = Ce n'est pas du TOML valable : { $detail }.
