parquet-damaged = Le fichier Parquet est endommagé ou incomplet.

parquet-column_lengths = Les colonnes du fichier Parquet diffèrent en longueur.

parquet-too_many_rows = Le fichier Parquet annonce { $n } lignes en { $size_bytes } octets.

parquet-not_readable = Le fichier Parquet est illisible ({ $detail }).

parquet-no_footer = La fin du fichier n'est pas celle d'un fichier Parquet.

parquet-footer_too_large = Le fichier Parquet annonce un pied de { $footer_bytes } octets ; il en a { $size_bytes }.

parquet-column_type = La colonne contient { $type } ; il faut des { $numbers ->
        [yes] nombres
       *[no] textes
     }.

parquet-encoding = La colonne a le codage { $encoding }, qui est refusé.

parquet-group_too_large = Un groupe a { $n } lignes et { $size_bytes } octets (limites { $most } et { $limit_bytes }).
