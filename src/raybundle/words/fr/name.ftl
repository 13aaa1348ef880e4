name-unprintable = { $name } n'est pas un nom imprimable.
