table-more_errors = Il y a d'autres erreurs ; le reste du fichier n'a pas été lu.

table-too_few_rows = Lignes de la table : { $n } ; nécessaire : { $least }.

table-empty = Le fichier est vide.

table-line_too_long = Ce n'est pas une table : plus de { $limit_bytes } octets { $empty ->
        [yes] de lignes vides
       *[no] dans une ligne
     }.

table-no_header = La première ligne contient des valeurs ({ LIST($header, most: 3) }) et non des noms de colonnes.

table-unknown_column = La colonne { $name } est inconnue.

table-column_twice = La colonne { $name } figure deux fois.

table-columns_missing = Colonnes manquantes : { $names }.

table-empty_line = La ligne est vide.

table-cell_count = Cellules de cette ligne : { $n } ; colonnes de l'en-tête : { $needed }.

table-pair_twice = Les mêmes valeurs de { LIST($names, most: 2) } figurent à la ligne { $earlier }.

table-time_order = Le temps { NUM($time_s, digits: 10) } s suit { NUM($before_s, digits: 10) } s.

table-row_unreadable = La ligne est illisible ({ $detail }).

table-quote_open = Une cellule dépasse la fin de sa ligne.

table-separator_unknown = { $value } n'indique aucun séparateur de table.

table-two_decimal_signs = Signes décimaux différents : { $later } ici, { $first } à la ligne { $first_line }, colonne { $first_column }.

table-csv_and_parquet = La table existe deux fois : { $csv } est dans le même dossier.

table-columns_together = Les colonnes { $names } demandent les colonnes { $missing }.

table-three_angles = Il faut trois angles d'un même type et d'une même unité.

table-one_position = La table demande soit { $grid }, soit { $geographic }.

table-not_increasing = { NUM($value, digits: 10) } suit { NUM($before, digits: 10) } ; la colonne doit être croissante.

table-no_such_column = Le tableau n'a pas de colonne { $name }.
