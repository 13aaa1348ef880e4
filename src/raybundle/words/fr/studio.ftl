studio-page_of_folder = what = { $page } demande une compensation, pas un dossier.

studio-path_of_folder = Un chemin est donné, mais le résultat est déjà dans un dossier.

studio-not_started = Le studio de { $folder } s'est terminé avec l'état { $status }{ $n ->
        [0] { " " }sans sortie
       *[other] {" "}: { $detail }
     }
