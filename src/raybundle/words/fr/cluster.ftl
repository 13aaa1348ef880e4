cluster-no_shards = Les lots (shards) ne conviennent pas ici : les passes d'une compensation dépendent les unes des autres.

cluster-package_missing = Un cluster demande le paquet { $package }.

cluster-no_address = { $address } n'est pas l'adresse d'un ordonnanceur.

cluster-other_machine = L'ordonnanceur est sur une autre machine ; son adresse seule n'a pas de certificats.

cluster-needs_certificates = Cette adresse demande des certificats.

cluster-certificates_missing = Des certificats manquent : { $names }.

cluster-not_encrypted = { $address } n'est pas chiffré (tls://).

cluster-no_certificate = Ce fichier ne contient pas de certificat.

cluster-certificates_expired = Les certificats ont expiré le { $date }.

cluster-certificates_not_usable = Les certificats ne sont pas utilisables ({ $detail }).

cluster-certificates_incomplete = Des certificats manquent : { $names }.

cluster-second_scheduler = Un ordonnanceur de ce cluster est déjà en marche ({ $address }).

cluster-cannot_listen = L'ordonnanceur ne peut pas écouter sur l'hôte { $host }, port { $port } ({ $detail }).

cluster-no_folder = Ce dossier n'existe pas, et aucun n'a été créé en { $wait_s } s.

cluster-other_version = Les versions diffèrent : { $found } là-bas, { $version } ici.

cluster-connection_lost = L'ordonnanceur ne répond pas ({ $detail }).

cluster-worker_blind = Le worker sur { $host } ne voit pas { $url ->
        [yes] le dépôt
       *[no] le dossier
     } comme cette machine :

cluster-worker_fails = Le worker sur { $host } a échoué dans { $n } tâches que cette machine peut faire.

cluster-no_worker = Aucun worker ne peut faire les tâches : { $n ->
        [0] il n'y en a pas
       *[other] aucun des { $n } n'a { $version }
     }.

cluster-no_scheduler = Aucun ordonnanceur n'y a été démarré : { $file_name } manque.

cluster-foreign_certificate = L'ordonnanceur à { $address } a un certificat d'un autre cluster ({ $detail }).

cluster-certificate_refused = L'ordonnanceur à { $address } refuse les certificats de ce dossier ({ $detail }).

cluster-timeout = L'ordonnanceur à { $address } ne répond pas en { $wait_s } s.

cluster-no_answer = Aucun ordonnanceur ne répond à { $address } ({ $detail }).

cluster-too_few_workers = { $n } de { $wanted } workers sont venus en { $wait_s } s.

cluster-nothing_awaited = Des workers sont attendus, mais aucun scheduler n'est donné.

cluster-dashboard_address = { $given } n'est ni un port ni HOST:PORT.

cluster-dashboard_package = Le tableau de bord a besoin du paquet { $package }.
