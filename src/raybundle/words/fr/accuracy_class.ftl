accuracy_class-no_unit = { OPTION("accuracy_class") } : la classe { $text } n'a pas d'unité.

accuracy_class-not_readable = { OPTION("accuracy_class") } : { $text } n'est pas une précision.
