toml-invalid = Ce n'est pas du TOML valable : { $detail }.

toml-keys_exclude = { $first } et { $second } s'excluent.

toml-unknown_key = La clé { $name } est inconnue.
