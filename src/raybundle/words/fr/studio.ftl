studio-page_of_folder = what = { $page } demande une compensation, pas un dossier.

studio-path_of_folder = Un chemin est donné, mais le résultat est déjà dans un dossier.

studio-not_started = Le studio de { $folder } s'est terminé avec l'état { $status }{ $n ->
        [0] { " " }sans sortie
       *[other] {" "}: { $detail }
     }

studio-no_figure = Il n'y a pas de figure { $number } ; il y en a { $n }, comptées à partir de 0.

studio-no_adjustment = Il n'y a pas encore de compensation.

studio-no_photographs = Aucun dossier ni fichier de photographies n'est donné.

studio-nothing_to_run = Aucune étape ne peut être exécutée dans ce dossier ; son bloc peut être compensé.

studio-busy = Une exécution ou une compensation est en cours.

studio-port_in_use = Le port { $port } n'est pas utilisable ({ $detail }).

studio-adjustment_not_stored = La compensation { $number } n'est pas enregistrée.

studio-adjustment_without_page = La compensation { $number } n'a pas de { $name }.

studio-photograph_file_unknown = Le fichier de cette photographie n'est pas connu.

studio-no_level = Il n'y a pas de niveau { $level } ; il y en a { $n }, comptés à partir de 0.

studio-tile_outside = La tuile { $across }, { $down } du niveau { $level } est hors de la photographie.
