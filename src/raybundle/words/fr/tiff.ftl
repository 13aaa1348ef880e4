tiff-ends_early = Le fichier TIFF s'arrête avant l'octet { $byte }.

tiff-no_tiff = Ce n'est pas un fichier TIFF.

tiff-too_many_tags = Le répertoire TIFF a { $n } étiquettes ; { $most } au plus sont lues.
