nitf-no_image = Le fichier NITF ne contient pas d'image.

nitf-no_rpc = La première image du fichier NITF n'a pas de RPC00B.

nitf-rpc_invalid = { $name } est incomplet ou invalide (SUCCESS { $success }).

nitf-field = Le champ NITF { $name } est { $value }, pas { $n } chiffres.
