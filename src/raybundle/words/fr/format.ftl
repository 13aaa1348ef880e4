format-unknown = Le format { $format } est inconnu.

format-only_written = Le format { $format } s'écrit mais ne se lit pas.

format-only_read = Le format { $format } se lit mais ne s'écrit pas.

format-needs_crs = Le format { $format } demande le système de coordonnées du bloc.

format-free_scale = Le format { $format } est en mètres, mais l'échelle du bloc n'est pas déterminée.

format-camera_deviation = Une caméra de ce format s'écarte de { $deviation_px } px au plus de l'original (limite { $limit_px } px).

format-needs_folder = { $format } est un dossier contenant { $files }.

format-degrees = { $format } a des coordonnées en longueurs ; { $system } est en degrés.

format-not_in_plane = { OPTION("within", flag: "in") } concerne les dessins ; le format { $format } n'en est pas un.

format-no_tables = { OPTION("tables") } concerne les dossiers de bloc ; le format { $format } n'en est pas un.

format-csv = Il n'y a pas de format csv.

format-file_suffix = Le format { $format } est un fichier de suffixe { $suffix }.

format-no_scenes = Le format { $format } n'a pas de scènes de satellite ; le bloc a { $scenes }.

format-ambiguous = Le fichier convient à plusieurs formats : { $names }.

format-not_recognised = Le format n'est pas reconnu.
