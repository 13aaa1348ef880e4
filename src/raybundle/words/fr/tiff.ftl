tiff-ends_early = Le fichier TIFF s'arrête avant l'octet { $byte }.

tiff-no_tiff = Ce n'est pas un fichier TIFF.

tiff-too_many_tags = Le répertoire TIFF a { $n } étiquettes ; { $most } au plus sont lues.

tiff-pixel_format = Les pixels ont { $bits } bits, format { $format } ; il faut des entiers de 8 ou 16 bits.

tiff-directory_damaged = Le répertoire TIFF n'indique pas la taille ou la position des pixels.

tiff-too_few_tiles = Le fichier TIFF a { $n } bandes ou tuiles ; il en faut { $needed }.

tiff-pixels_end_early = Les pixels du fichier TIFF s'arrêtent trop tôt.

tiff-pixels_unreadable = Les pixels ne peuvent être décodés (compression { $compression }, canaux { $bands }, bits { $bits }).

tiff-compression = Les pixels sont compressés par la méthode { $compression }, qui demande l'extra [geo].
