action-unknown_verb = Le verbe { $verb } est inconnu.

action-unknown_argument = { $verb } : l'argument { $name } est inconnu.

action-arguments = { $verb } : les arguments ne sont pas valables ({ $detail }).
