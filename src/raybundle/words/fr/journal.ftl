journal-nothing_to_undo = Il n'y a rien à annuler.

journal-nothing_to_redo = Il n'y a rien à rétablir : la dernière action n'a pas été annulée.

journal-no_place = Rien ne peut être mesuré dans ce dossier.

journal-two_journals = Le projet a deux journaux : celui-ci, à côté du résultat, et { $other }.

journal-text_too_long = { $entry } { $text } a { $n } caractères ; le maximum est { $most }.

journal-text_not_printable = { $entry } { $text } contient des caractères non imprimables.

journal-id_used = L'identifiant d'action { $id } est déjà utilisé par une autre action, { $action } ({ $verb }).

journal-moved = Le journal a été déplacé, supprimé ou remplacé depuis son ouverture ; rien n'a été ajouté.

journal-damaged = L'action { $action } du journal est endommagée.

journal-number_not_finite = { $verb } : un nombre n'est pas fini.

journal-other_database = Cette base de données n'est pas un journal de mesures.

journal-schema = Le journal a été écrit par une autre version (schéma { $found } ; celle-ci lit { $read }).

journal-foreign_action = L'action { $action } du journal n'est pas valable.

journal-read_only = Aucune mesure possible : le dossier { $folder } est protégé en écriture.

journal-not_usable = Le journal n'est pas utilisable ({ $detail }).
