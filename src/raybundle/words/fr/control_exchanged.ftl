control_exchanged = Les points d'appui { $first } et { $second } semblent intervertis ; { $few ->
     [yes] aucun point d'appui n'est utilisé
     *[no] ils ne sont pas utilisés
    }.
