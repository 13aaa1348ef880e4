outline-crosses_itself = { $name } schneidet sich selbst bei den Seiten ab den Ecken { $first } und { $second }.
    .do = Die Ecken in ihrer Folge entlang des Umrisses angeben.

outline-no_area = { $name } umschließt keine Fläche.
    .do = Mindestens drei Ecken angeben, die nicht auf einer Geraden liegen.
