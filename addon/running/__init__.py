"""From a request to a drawing: preparing, drawing, jobs, what to say when it cannot be done."""
