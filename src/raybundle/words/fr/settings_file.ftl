settings_file-flag_only = { $flag } n'est possible qu'en ligne de commande, pas dans un fichier.

settings_file-unknown_table = { $table ->
        [yes] [{ $name }] n'est pas la table d'une commande
       *[no] { $name } n'est dans aucune table de commande, ni dans { $general }
     }.

settings_file-unknown_option = { $entry } : { $every ->
        [yes] aucune commande n'a
       *[no] { $command } n'a pas
     } l'option { $flag }.
