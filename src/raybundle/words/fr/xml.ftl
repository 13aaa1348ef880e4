xml-invalid = Ce n'est pas du XML valable : { $detail }.

xml-element_missing = L'élément { $path } manque.

xml-attribute_missing = L'attribut { $name } manque.

xml-attribute_not_a_number = Attribut { $name } : { $value } n'est pas un nombre fini.

xml-doctype = Le type de document (DOCTYPE) est refusé par sécurité.

xml-empty = Le fichier n'a pas d'élément racine ; { $root } est attendu.

xml-root_element = L'élément racine est { $name }, non { $root }.
