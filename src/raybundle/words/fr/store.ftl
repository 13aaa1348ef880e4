store-not_confirmed = Le projet nomme le dépôt { $url }, jamais utilisé depuis cette machine.

store-copies_no_folder = Le dossier des copies, { $folder }, n'est pas possible : { $place } est un fichier.

store-copies_size = { $variable } = { $value } n'est pas un nombre de gigaoctets.

store-copies_not_writable = Les copies de produits ne peuvent pas être écrites ({ $detail }).

store-occupied = Un autre dossier existe déjà à { $place }.

store-no_bucket = Le bucket n'existe pas, ou rien ne peut y être écrit.

store-foreign_token = L'objet nommé token à cet endroit n'appartient pas à raybundle.

store-package_missing = Un dépôt à une URL demande le paquet { $package }.

store-secret = L'URL contient un secret, qui serait visible dans les fichiers et messages.

store-service_package = Un paquet pour ce type de dépôt manque ({ $detail }).

store-invalid_url = L'URL n'est pas valable ({ $detail }).

store-not_reachable = Le dépôt n'est pas joignable ({ $detail }).

store-no_bucket_name = L'URL ne nomme pas de bucket ou de dossier.

store-no_url = Le dépôt n'est pas donné comme URL.

store-no_products = Le dépôt ne contient pas de produits d'un projet.

store-in_memory = Le dépôt est dans la mémoire de ce processus ; les autres ne le voient pas.

store-not_readable = Le dépôt n'est pas lisible ({ $detail }).

store-no_folder_name = L'URL ne nomme pas de dossier.

store-escaped = Dans cette URL, { $text } ferait partie du nom du dossier.

store-is_a_file = Le dépôt est un fichier.

store-not_separate = Le dépôt est dans le dossier { $kind ->
        [result] du résultat
       *[input] des données d'entrée
     } ({ $place }).

store-not_writable = Le dépôt ne peut pas être créé ou écrit ({ $detail }).

store-lost = Le dépôt ne fonctionne pas ({ $detail }), { $n } essais.

store-chained = Une URL enchaînée (::) ne peut pas être un dépôt.

store-web_page = Rien ne peut être écrit par { $scheme }.

store-unknown_scheme = { $scheme }:// n'est pas un type de dépôt.

store-of_last_run = Le dépôt de la dernière exécution est inutilisable.
