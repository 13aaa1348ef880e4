dataset-name = { $name } n'est pas un nom de jeu de données valable.

dataset-address = { $address } n'est pas l'adresse d'un dossier.

dataset-file_entry = Un fichier de jeu de données demande trois valeurs.

dataset-path_outside = { $path } sort du dossier du jeu de données.

dataset-no_sha256 = { $value } n'est pas une somme SHA-256.

dataset-unknown = Le jeu de données { $name } est inconnu.

dataset-checksum = Le fichier a { $size_bytes } octets et la somme { $sha256 } ; attendu { $expected_bytes } et { $expected_sha256 }.

dataset-connection_ended = La connexion s'est arrêtée après { $received_bytes } octets sur { $size_bytes }.

dataset-connection_broken = La connexion a été interrompue ({ $detail }).

dataset-server_answer = Le serveur répond { $status } { $detail }.

dataset-no_connection = Pas de connexion à { $host } ({ $detail }).

dataset-incomplete = { $name } manque ; un jeu contient photos, measured.csv et truth.
