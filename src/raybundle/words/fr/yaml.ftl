yaml-indentation = La ligne est moins indentée que son bloc.

yaml-second_document = Un deuxième document commence ici.

yaml-tab = La ligne est indentée par une tabulation.

yaml-open_list = Une liste commencée ici n'a pas de fin.

yaml-no_entry = Une entrée KEY: VALUE est attendue ici.

yaml-list_form = La liste est mal formée.

yaml-not_supported = Les ancres et blocs de texte YAML ne sont pas pris en charge.
