object-takes_no_line = L'objet { $name } n'accepte pas de ligne de points.

object-number_count = Objet { $name } : { $n } nombres sont donnés.

object-dimension_out_of_range = Objet { $name } : { $dimension } vaut { $value_m } m.

object-unknown = L'objet { $text } n'est ni un type d'objet, ni un fichier ou dossier d'objet.

object-number_form = Objet { $text } : { $name } demande des nombres séparés par des virgules.
