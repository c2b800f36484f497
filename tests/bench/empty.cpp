// Linked to the libraries of the command and doing nothing: what starting a process costs.
int main() {
    return 0;
}
