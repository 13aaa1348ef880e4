json-invalid = Ce n'est pas du JSON valable : { $detail } (caractère { $character }).

json-key_twice = La clé { $name } figure deux fois dans un objet.

json-not_finite = { $value } n'est pas un nombre en JSON.
