export-no_csv_name = Le nom d'une table de points se termine par .csv.

export-no_points = Aucun point n'est mesuré à la main ; il n'y a rien à exporter.

export-name_not_possible = { $kind ->
        [image] L'image
       *[point] Le point
     } { $name } ne peut pas être écrit dans gcp_list.txt.

export-no_control = Aucun point d'appui ou de contrôle avec X, Y et Z n'est marqué ; il n'y a rien à exporter.

export-not_one_file = Pas un fichier unique : format { LIST($formats, most: 20) }.

export-same_file = Deux des formats { LIST($formats, most: 20) } ont le même nom de fichier.

export-format_failed = Le format { $format } n'est pas écrit :

export-formats_failed = Formats qui ne peuvent pas être écrits : { $n } ; écrits : { $written ->
        [0] aucun
       *[other] { LIST($places, most: 20) }
     }.
