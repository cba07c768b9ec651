// Words: the texts of a sheet. Owns a table of sentences and one of fixed words, each row in every language, and the
// typesetting of symbols and numbers. Independent of pages; the meaning of a sentence is documented in
// engine/sentences/statement.hpp.
//
// Patterns: {0} … are arguments; {0|one|several} chooses by the number of items in {0}; text in [square brackets] is
// omitted if one of its arguments is missing; ~ is a no-break space; ω and α are typeset as symbols (α is ω̇ in
// Italian), × becomes ∧ in Italian.
#include "render/text/words.hpp"
#include "render/text/numbered_lines.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "engine/number/assert.hpp"
#include "engine/number/index.hpp"
#include "render/text/joined_names.hpp"

namespace kinegraph::render {
namespace {

struct Row {
    Sentence sentence;
    std::string_view en, it;
};

// Rows too long for a line make clang-format break the head of the table.
// clang-format off
constexpr std::array
    sentences{
        Row{Sentence::crank_velocity, "Body {0} turns about {1}: {3} is normal to {1}{2} and has the magnitude "
                                      "{4}~{1}{2}.",
            "Il corpo {0} ruota attorno a {1}: {3} è normale a {1}{2} e ha modulo {4}~{1}{2}."},
        Row{Sentence::crank_acceleration,
            "Body {0} turns about {1}: {3} has the normal part {4}²~{1}{2}, directed from {2} to {1}[, and the "
            "tangential part {5}~{1}{2}, normal to {1}{2}].",
            "Il corpo {0} ruota attorno a {1}: {3} ha componente normale {4}²~{1}{2}, diretta da {2} verso {1}[, e "
            "componente tangenziale {5}~{1}{2}, normale a {1}{2}]."},
        Row{Sentence::image_velocity,
            "The image of body {1} gives {2}[: to the velocity of {3} add {4}~{3}{0}, normal to {3}{0}].",
            "L’immagine del corpo {1} dà {2}[: alla velocità di {3} si aggiunge {4}~{3}{0}, normale a {3}{0}]."},
        Row{Sentence::image_acceleration,
            "The image of body {1} gives {2}[: to the acceleration of {3} add {4}²~{3}{0}, directed from {0} towards "
            "{3}][, and {5}~{3}{0}, normal to {3}{0}].",
            "L’immagine del corpo {1} dà {2}[: all’accelerazione di {3} si aggiunge {4}²~{3}{0}, diretta da {0} "
            "verso {3}][, e {5}~{3}{0}, normale a {3}{0}]."},
        Row{Sentence::translating_velocity, "Body {0} translates, so {1} moves as all its points do: {2}.",
            "Il corpo {0} trasla, quindi {1} si muove come tutti i suoi punti: {2}."},
        Row{Sentence::translating_acceleration, "Body {0} translates: {1} has the acceleration of all its points, {2}.",
            "Il corpo {0} trasla: {1} ha l’accelerazione di tutti i suoi punti, {2}."},
        Row{Sentence::image_acceleration_without_omega,
            "The image of body {1}, which does not turn at this instant, gives {2}[: to the acceleration of {3} add "
            "{4}~{3}{0} alone, normal to {3}{0}].",
            "L’immagine del corpo {1}, che in questo istante non ruota, dà {2}[: all’accelerazione di {3} si "
            "aggiunge soltanto {4}~{3}{0}, normale a {3}{0}]."},
        Row{Sentence::two_lines_velocity,
            "Through the known ends draw the lines {1} and {2}: they meet in {0} and close the polygon.",
            "Per gli estremi noti si tracciano le rette {1} e {2}, che si incontrano in {0} e chiudono il poligono."},
        Row{Sentence::two_lines_acceleration,
            "Set off the known terms; through their ends draw the lines {1} and {2}: they meet in {0} and close the "
            "polygon.",
            "Si riportano i termini noti; per i loro estremi si tracciano le rette {1} e {2}, che si incontrano in "
            "{0} e chiudono il poligono."},
        Row{Sentence::omega_from_pair, "[{1} goes from {4} to {5}. ]{0} is {1} divided by {2}; its sense is that in "
                                       "which {1} turns {2}.",
            "[{1} va da {4} a {5}. ]{0} è {1} diviso {2}; il verso è quello in cui {1} fa ruotare {2}."},
        Row{Sentence::alpha_from_pair,
            "[From {4} set off {6}; from its end {1} goes to {5}. ]{0} is {1} divided by {2}; its sense is that in "
            "which {1} turns {2}.",
            "[Da {4} si riporta {6}; dal suo estremo {1} va a {5}. ]{0} è {1} diviso {2}; il verso è quello in cui "
            "{1} fa ruotare {2}."},
        Row{Sentence::omega_by_sleeve, "The sliding pair at {2} allows no relative rotation: {0}~=~{1}.",
            "La coppia prismatica in {2} non consente rotazione relativa: {0}~=~{1}."},
        Row{Sentence::alpha_by_sleeve, "The sliding pair at {2} never allows a relative rotation, so {0}~=~{1} too.",
            "La coppia prismatica in {2} non consente mai rotazione relativa, quindi anche {0}~=~{1}."},
        Row{Sentence::omega_by_joint, "The joint at {2} allows no relative rotation: {0}~=~{1}.",
            "Il vincolo in {2} non consente rotazione relativa: {0}~=~{1}."},
        Row{Sentence::alpha_by_joint, "The joint at {2} never allows a relative rotation, so {0}~=~{1} too.",
            "Il vincolo in {2} non consente mai rotazione relativa, quindi anche {0}~=~{1}."},
        Row{Sentence::omega_by_fixed_guide, "The guide at {2} is fixed, so body {1} does not turn: {0}~=~0.",
            "La guida in {2} è fissa, quindi il corpo {1} non ruota: {0}~=~0."},
        Row{Sentence::alpha_by_fixed_guide, "Body {1} never turns: {0}~=~0.", "Il corpo {1} non ruota mai: {0}~=~0."},
        Row{Sentence::omega_by_driver, "The driver gives {0}[ relative to {1}].", "Il movente assegna {0}[ rispetto "
            "a {1}]."},
        Row{Sentence::alpha_by_driver, "The driver gives {0}[ relative to {1}].", "Il movente assegna {0}[ rispetto "
            "a {1}]."},
        Row{Sentence::slide_velocity,
            "At {1} both velocities are known: {0} joins their tips and is the velocity with which body {2} slides "
            "on body {3}.",
            "In {1} sono note le due velocità: {0} ne congiunge gli estremi ed è la velocità relativa del corpo {2} "
            "rispetto al corpo {3}."},
        Row{Sentence::slide_acceleration,
            "At {1}, once the Coriolis term is set off, {0} closes the polygon: it is the relative acceleration of "
            "body {2} on body {3}.",
            "In {1}, riportato il termine di Coriolis, {0} chiude il poligono: è l’accelerazione relativa del corpo "
            "{2} rispetto al corpo {3}."},
        Row{Sentence::slide_acceleration_without_coriolis,
            "At {1} there is no Coriolis term: {0} joins the tips of the two accelerations and is the relative "
            "acceleration of body {2} on body {3}.",
            "In {1} il termine di Coriolis è nullo: {0} congiunge gli estremi delle due accelerazioni ed è "
            "l’accelerazione relativa del corpo {2} rispetto al corpo {3}."},
        Row{Sentence::slide_velocity_on_rest, "The guide at {1} is at rest: {0}, the velocity along it, is {2} itself.",
            "La guida in {1} è ferma: {0}, velocità lungo la guida, coincide con {2}."},
        Row{Sentence::slide_acceleration_on_rest, "The guide at {1} is at rest: {0} is {2} itself, without a "
                                                  "Coriolis term.",
            "La guida in {1} è ferma: {0} coincide con {2}, senza termine di Coriolis."},
        Row{Sentence::driven_point_velocity, "With the driver at {1}, {0} is known in magnitude and direction.",
            "Con il movente in {1} è nota {0}, in modulo e direzione."},
        Row{Sentence::driven_point_acceleration, "With the driver at {1}, {0} is known in magnitude and direction.",
            "Con il movente in {1} è nota {0}, in modulo e direzione."},
        Row{Sentence::auxiliary_point, "On body {1} the normals to the two known directions, {2} and {3}, meet in "
                                       "the auxiliary point {0}[, at x~=~{4}, y~=~{5}].",
            "Sul corpo {1} le normali alle due direzioni note, {2} e {3}, si incontrano nel punto ausiliario {0}[, "
            "di coordinate x~=~{4}, y~=~{5}]."},
        Row{Sentence::omega_from_parallels,
            "The two directions known on body {2} are parallel: their distance in the polygon gives {0}~=~Δv/{1}.",
            "Le due direzioni note sul corpo {2} sono parallele: la loro distanza nel poligono dà {0}~=~Δv/{1}."},
        Row{Sentence::alpha_from_parallels,
            "The two directions known on body {2} are parallel: their distance in the polygon gives {0}~=~Δa/{1}.",
            "Le due direzioni note sul corpo {2} sono parallele: la loro distanza nel poligono dà {0}~=~Δa/{1}."},
        Row{Sentence::rolling_point_at_rest,
            "Body {1} rolls without slip on body {2}, which is at rest: its point at the contact {0} stands still, "
            "{3}~=~0.",
            "Il corpo {1} rotola senza strisciare sul corpo {2}, che è fermo: il suo punto di contatto {0} ha "
            "velocità nulla, {3}~=~0."},
        Row{Sentence::rolling_velocity,
            "Bodies {1} and {2} roll without slip at {0}: the points in contact have one velocity, {3}~=~{4}.",
            "I corpi {1} e {2} rotolano senza strisciare in {0}: i punti a contatto hanno la stessa velocità, "
            "{3}~=~{4}."},
        Row{Sentence::rolling_point_on_rest_acceleration,
            "At {0} body {1} rolls on body {2}, which is at rest: {3} has no tangential part; along the normal it is "
            "ω²~{6}.",
            "In {0} il corpo {1} rotola sul corpo {2}, che è fermo: {3} non ha componente tangenziale; lungo la "
            "normale vale ω²~{6}."},
        Row{Sentence::rolling_acceleration,
            "At {0} bodies {1} and {2} roll on each other: {3} differs from {4} by {5} alone, along the normal: "
            "ω²~{6} with the relative ω.",
            "In {0} i corpi {1} e {2} rotolano l’uno sull’altro: {3} differisce da {4} solo per {5}, lungo la "
            "normale: ω²~{6} con la ω relativa."},
        Row{Sentence::equivalent_link,
            "At the contact {2} bodies {0} and {1} slide along the common tangent; up to accelerations they move as "
            "if a link joined their centres of curvature, {3}.",
            "Nel contatto {2} i corpi {0} e {1} strisciano lungo la tangente comune; fino alle accelerazioni si "
            "muovono come se un’asta congiungesse i centri di curvatura, {3}."},
        Row{Sentence::equivalent_slot,
            "At the contact {2} body {0} slides along the straight side of body {1}: its centre {3} moves as a pin "
            "in a slot parallel to that side.",
            "Nel contatto {2} il corpo {0} striscia sul fianco rettilineo del corpo {1}: il suo centro {3} si muove "
            "come un perno in un glifo parallelo al fianco."},
        Row{Sentence::equivalent_tip,
            "The tip {2} of body {0} slides along the straight side of body {1}, as a pin in a slot does.",
            "La punta {2} del corpo {0} striscia sul fianco rettilineo del corpo {1}, come un perno in un glifo."},
        Row{Sentence::contact_tangent,
            "At the contact {2} bodies {0} and {1} have no relative velocity along the common normal: it lies along "
            "the tangent.",
            "Nel contatto {2} i corpi {0} e {1} non hanno velocità relativa lungo la normale comune: essa è diretta "
            "come la tangente."},
        Row{Sentence::pitch_curves,
            "The pitch curves of bodies {0} and {1} roll on each other at {2}: the points in contact, {3} of body "
            "{0} and {4} of body {1}, have equal velocities along the common tangent.",
            "Le primitive dei corpi {0} e {1} rotolano l’una sull’altra in {2}: i punti a contatto, {3} del corpo "
            "{0} e {4} del corpo {1}, hanno uguale velocità lungo la tangente comune."},
        Row{Sentence::primary_revolute, "{0} is the hinge {1}.", "{0} è la cerniera {1}."},
        Row{Sentence::primary_prismatic, "{0} is at infinity, normal to the guide at {1}.",
            "{0} è all’infinito, in direzione normale alla guida in {1}."},
        Row{Sentence::primary_rolling, "{0} is the contact {1}: there is rolling without slip.",
            "{0} è il contatto {1}: rotolamento senza strisciamento."},
        Row{Sentence::primary_gear, "{0} is the pitch point {1}.", "{0} è il punto primitivo {1}."},
        Row{Sentence::primary_weld, "At {1} the bodies are clamped: every point may serve as {0}.",
            "In {1} i corpi sono incastrati: ogni punto può fare da {0}."},
        Row{Sentence::kennedy, "{0} is where {1}{2} meets {3}{4} (Aronhold–Kennedy).",
            "{0} è l’incontro di {1}{2} con {3}{4} (Aronhold–Kennedy)."},
        Row{Sentence::kennedy_line, "{0} is where {1}{2} meets the normal at {3}.",
            "{0} è l’incontro di {1}{2} con la normale in {3}."},
        Row{Sentence::kennedy_two_normals, "{0} is where the normals at {1} and {2} meet.",
            "{0} è l’incontro delle normali in {1} e {2}."},
        Row{Sentence::kennedy_same, "{1} and {2} coincide, so {0} is there too.", "{1} e {2} coincidono, quindi "
            "anche {0} è lì."},
        Row{Sentence::centre_by_rigidity, "Two of the bodies do not move relative to each other: {0} coincides with "
                                          "{1}.",
            "Due dei corpi non si muovono l’uno rispetto all’altro: {0} coincide con {1}."},
        Row{Sentence::no_relative_motion,
            "No motion that this position allows moves bodies {0} against each other: every point may serve as "
            "their centre.",
            "Nessun moto possibile in questa configurazione muove i corpi {0} l’uno rispetto all’altro: ogni punto può "
            "fare da loro centro."},
        Row{Sentence::centre_from_velocities,
            "{0} from the velocities: the normals to the relative velocities[ of {1} and {2}] meet there.",
            "{0} dalle velocità: vi si incontrano le normali alle velocità relative[ di {1} e {2}]."},
        Row{Sentence::second_way, "Second way: {3} moves alike on both bodies, so {0}~=~{4}~{1}{3}/{2}{3}, as by the "
                                  "polygon.",
            "Seconda via: {3} ha la stessa velocità sui due corpi, quindi {0}~=~{4}~{1}{3}/{2}{3}, come dal poligono."},
        Row{Sentence::trial_on_line,
            "No dyad or triad leads on, so {0} is tried at two places of its line, {1}; from each the polygon is "
            "carried on (thin broken lines).",
            "Nessuna diade o triade permette di proseguire: si prova {0} in due posizioni sulla sua retta, {1}, e da "
            "ciascuna si continua il poligono (linee sottili a tratti)."},
        Row{Sentence::trial_of_spin,
            "No dyad or triad leads on, so {0} is given two trial values, and from each the polygon is carried on.",
            "Nessuna diade o triade permette di proseguire: si danno a {0} due valori di prova, e da ciascuno si "
            "continua il poligono."},
        Row{Sentence::trial_closes_on_line,
            "{0} must lie on the line {1}; the two trials miss it by {3} and {4}. Everything is linear, so the true "
            "{2} follows in proportion.",
            "{0} deve stare sulla retta {1}; le due prove se ne scostano di {3} e {4}. Tutto è lineare: {2} si "
            "ricava in proporzione."},
        Row{Sentence::trial_closes_by_spin,
            "{0} and {1} must agree. Everything is linear, so the true {2} follows in proportion from how far they "
            "differ in the two trials.",
            "{0} e {1} devono coincidere. Tutto è lineare: dalle loro differenze nelle due prove si ricava in "
            "proporzione {2}."},
        Row{Sentence::relative_transport_velocity,
            "Seen from body {1}, {0} moves with {3}: its velocity minus the transport velocity {2}.",
            "Rispetto al corpo {1}, {0} ha velocità relativa {3}: quella assoluta meno quella di trascinamento {2}."},
        Row{Sentence::relative_transport_acceleration,
            "Seen from body {1}, {0} has {4}: its acceleration minus the transport term {2} and the Coriolis term {3}.",
            "Rispetto al corpo {1}, {0} ha accelerazione relativa {4}: quella assoluta meno quella di trascinamento "
            "{2} e quella di Coriolis {3}."},
        Row{Sentence::relative_translating_velocity,
            "Seen from axes that translate with {1}, {0} moves with {3}: its velocity minus {2}.",
            "Rispetto ad assi traslanti con {1}, {0} ha velocità relativa {3}: quella assoluta meno {2}."},
        Row{Sentence::relative_translating_acceleration,
            "Seen from axes that translate with {1}, {0} has {3}: its acceleration minus {2}; axes that translate "
            "bring no Coriolis term.",
            "Rispetto ad assi traslanti con {1}, {0} ha accelerazione relativa {3}: quella assoluta meno {2}; con "
            "assi traslanti il termine di Coriolis è nullo."},
        Row{Sentence::observer_velocity,
            "Observer on body {1}: {2}~=~{3}~+~{4}, the transport velocity {3} of the place of body {1} under {0}, "
            "and the relative velocity {4}, of which the direction is known.",
            "Osservatore solidale al corpo {1}: {2}~=~{3}~+~{4}, con {3} velocità di trascinamento, quella del punto "
            "del corpo {1} che coincide con {0}, e {4} velocità relativa, nota in direzione."},
        Row{Sentence::observer_acceleration,
            "Observer on body {1}: {2} is the sum of the transport acceleration {3} of the place of body {1} under "
            "{0}[, of Coriolis’ {5}] and of the relative acceleration {4}, of which the direction is known.",
            "Osservatore solidale al corpo {1}: {2} è la somma dell’accelerazione di trascinamento {3} del punto del "
            "corpo {1} che coincide con {0}[, di quella di Coriolis {5}] e di quella relativa {4}, nota in direzione."},
        Row{Sentence::not_through_observer,
            "The motion cannot be found from {0} as seen from body {1}: no guide of that body gives a direction "
            "there; it was found another way, and the relative motion is shown.",
            "Il moto non si può trovare osservando {0} dal corpo {1}: nessuna guida di quel corpo dà lì una "
            "direzione; si è seguita un’altra via, e il moto relativo è mostrato."},
        Row{Sentence::inertia_force, "The inertia force of body {0} acts at {3}, opposite to {2}: {1}~=~−m~{2}.",
            "La forza d’inerzia del corpo {0} agisce in {3}, opposta a {2}: {1}~=~−m~{2}."},
        Row{Sentence::inertia_couple,
            "The inertia couple of body {0} is opposite to {2}: {1}~=~−J~{2}, J about its centre of mass.",
            "La coppia d’inerzia del corpo {0} è opposta a {2}: {1}~=~−J~{2}, J rispetto al baricentro."},
        Row{Sentence::two_force_body, "Body {0} carries two forces only, so both act along {1}{2}.",
            "Sul corpo {0} agiscono due sole forze: entrambe sono dirette secondo {1}{2}."},
        Row{Sentence::two_force_guide, "Body {0} carries two forces only: both pass through {1}, normal to the guide "
                                       "at {2}.",
            "Sul corpo {0} agiscono due sole forze: entrambe passano per {1}, normali alla guida in {2}."},
        Row{Sentence::two_force_group, "Bodies {0}, taken together, carry two forces only, so both act along {1}{2}.",
            "I corpi {0}, presi insieme, sono soggetti a due sole forze: entrambe sono dirette secondo {1}{2}."},
        Row{Sentence::zero_forces, "On body {0} the two forces could not have one line of action: both vanish.",
            "Sul corpo {0} le due forze non possono avere la stessa retta d’azione: sono entrambe nulle."},
        Row{Sentence::two_forces_and_couple,
            "Body {0} carries two forces and a couple: the forces are equal and opposite, so the one at {1} is "
            "parallel to the other.",
            "Sul corpo {0} agiscono due forze e una coppia: le forze sono uguali e opposte, quindi quella in {1} è "
            "parallela all’altra."},
        Row{Sentence::three_force_line, "On body {0} two lines of action meet in {1}, so {2} acts along {3}{1}.",
            "Sul corpo {0} due rette d’azione si incontrano in {1}: {2} è diretta secondo {3}{1}."},
        Row{Sentence::three_parallel_lines, "On body {0} all other lines of action are parallel, so {1} is parallel "
                                            "to them.",
            "Sul corpo {0} tutte le altre rette d’azione sono parallele: anche {1} è parallela ad esse."},
        Row{Sentence::triangle, "The force triangle of body {0} closes and gives {1} and {2}.",
            "Il triangolo delle forze del corpo {0} si chiude e dà {1} e {2}."},
        Row{Sentence::triangle_at,
            "On body {0} the lines of the known force and of {2} meet in {1}; {3} passes there too, and the triangle "
            "gives both.",
            "Sul corpo {0} le rette della forza nota e di {2} si incontrano in {1}; anche {3} vi passa, e il "
            "triangolo dà entrambe."},
        Row{Sentence::polygon, "The force polygon of body {0} closes and gives {1} and {2}.",
            "Il poligono delle forze del corpo {0} si chiude e dà {1} e {2}."},
        Row{Sentence::polygon_at,
            "On body {0} the resultant of the known forces and the line of {2} meet in {1}; {3} passes there too, "
            "and the polygon gives both.",
            "Sul corpo {0} la risultante delle forze note, {2} e {3} concorrono in {1}: il poligono dà le due "
            "incognite."},
        Row{Sentence::parallel_forces, "The forces on body {0} are parallel: moments give {1}, the sum gives {2}.",
            "Le forze sul corpo {0} sono parallele: i momenti danno {1}, la somma {2}."},
        Row{Sentence::culmann,
            "Body {0} carries four forces: the lines of {3} and {4} meet in {1}, moments about it give {2}, and the "
            "polygon the rest (Culmann).",
            "Sul corpo {0} agiscono quattro forze: le rette di {3} e {4} si incontrano in {1}, i momenti rispetto ad "
            "esso danno {2} e il poligono le altre (Culmann)."},
        Row{Sentence::culmann_line,
            "Body {0} carries four forces: the known one meets {3} in {1}, {4} meets {5} in {2}. Culmann’s line "
            "{1}{2} carries the sum of each pair, and two triangles close.",
            "Sul corpo {0} agiscono quattro forze: quella nota incontra {3} in {1}, {4} incontra {5} in {2}. La "
            "retta di Culmann {1}{2} porta la somma di ciascuna coppia di forze e si chiudono due triangoli."},
        Row{Sentence::force_and_couple,
            "On body {0} {1} is equal and opposite to the resultant of the other forces; {2} balances the couple "
            "that they form, force times arm.",
            "Sul corpo {0} {1} è opposta alla risultante delle altre forze; {2} equilibra la coppia che ne nasce, "
            "forza per braccio."},
        Row{Sentence::single_reaction, "On body {0} only {1} is unknown: it balances the rest.",
            "Sul corpo {0} resta incognita solo {1}, che equilibra tutto il resto."},
        Row{Sentence::superposition,
            "No order of bodies resolves all loads at once: now those of body {0} act alone; what they cause is "
            "marked ({0}).",
            "Nessun ordine dei corpi risolve tutti i carichi insieme: agiscano ora i soli carichi del corpo {0}; ciò "
            "che provocano è contrassegnato con ({0})."},
        Row{Sentence::superposition_sum, "The partial forces at each joint are added, tip to tail, and so are the "
                                         "couples.",
            "In ciascuna coppia si sommano le forze parziali, una di seguito all’altra; così pure i momenti."},
        Row{Sentence::through_pin, "All that is known on body {0} passes through {1}: {2} must pass there too.",
            "Tutto ciò che è noto sul corpo {0} passa per {1}: anche {2} deve passarvi."},
        Row{Sentence::known_resultant, "On body {0} the resultant of {1} is {2}.", "Sul corpo {0} la risultante di "
            "{1} è {2}."},
        Row{Sentence::inertia_moved, "On body {0} {1} and {2} are one force: {1}, moved aside by d~=~M/F.",
            "Sul corpo {0} {1} e {2} equivalgono a una sola forza: {1}, spostata di d~=~M/F."},
        Row{Sentence::funicular_parallel,
            "The forces on body {0} are parallel: the strings, parallel to the rays from a pole, give the line of "
            "their resultant[, through {3} where the outer ones meet], and the closing line parts it into {1} and "
            "{2} (funicular polygon).",
            "Le forze sul corpo {0} sono parallele: i lati del poligono funicolare, paralleli ai raggi condotti da "
            "un polo, danno la retta della risultante[, per {3} dove si incontrano i lati estremi], e la retta di "
            "chiusura la ripartisce fra {1} e {2}."},
        Row{Sentence::funicular_far,
            "On body {0} the line of {1} meets that of the known forces far away: a funicular polygon that begins at "
            "the point of {2} closes, and its closing line gives both.",
            "Sul corpo {0} la retta di {1} incontra lontano quella delle forze note: si chiude un poligono "
            "funicolare che parte dal punto di {2}, e la retta di chiusura dà entrambe."},
        Row{Sentence::funicular_several,
            "On body {0} a funicular polygon that begins at the point of {2}, with its strings parallel to the rays "
            "from a pole, joins the lines of {3}: its outer strings meet[ in {4},] on the line of their resultant, "
            "and the closing line gives {1} and {2}.",
            "Sul corpo {0} un poligono funicolare che parte dal punto di {2}, con i lati paralleli ai raggi condotti "
            "da un polo, collega le rette di {3}: i lati estremi si incontrano[ in {4},] sulla retta della "
            "risultante, e la retta di chiusura dà {1} e {2}."},
        Row{Sentence::trial, "{0} is given a trial value; from the closing error its true value follows in proportion.",
            "A {0} si dà un valore di prova; dallo scarto di chiusura si ricava in proporzione il valore vero."},
        Row{Sentence::equations_together,
            "No order of bodies leads on. The {1} equilibrium equations of body {0} have {1} unknowns and are solved "
            "together by elimination[, which gives in this order {2}].",
            "Nessun ordine dei corpi conduce oltre. Le {1} equazioni di equilibrio del corpo {0} hanno {1} incognite e "
            "si risolvono insieme per eliminazione[, che dà nell’ordine {2}]."},
        Row{Sentence::elastic_spring, "The spring acts along {1}{2}: {0} is its stiffness times what {1}{2} exceeds "
                                      "the free length by.",
            "La molla agisce lungo {1}{2}: {0} è la rigidezza per l’allungamento di {1}{2} rispetto alla lunghezza a "
            "riposo."},
        Row{Sentence::torsion_spring, "The torsion spring turns body {1} back against body {2}: {0}~=~−k~φ.",
            "La molla di torsione richiama il corpo {1} rispetto al corpo {2}: {0}~=~−k~φ."},
        Row{Sentence::distributed_load,
            "The load distributed on {2}{3} of body {0} has the area of its diagram for its resultant {1}, through "
            "the centroid of that area, at x from {2}.",
            "Il carico distribuito su {2}{3} del corpo {0} ha per risultante {1} l’area del suo diagramma, applicata "
            "nel baricentro di essa, a x da {2}."},
        Row{Sentence::distributed_couple, "The two halves of the load on {2}{3} of body {0} are equal and opposite: "
                                          "they make the couple {1}.",
            "Le due metà del carico su {2}{3} del corpo {0} sono uguali e opposte: formano la coppia {1}."},
        Row{Sentence::in_equilibrium, "The forces given on body {0} close their polygon, and their moments balance: "
                                      "equilibrium.",
            "Le forze assegnate sul corpo {0} chiudono il poligono e i loro momenti si fanno equilibrio."},
        Row{Sentence::resultant_force, "The polygon of what is given on body {0} does not close: the gap is the "
                                       "resultant {1}; its line follows by moments.",
            "Il poligono di ciò che è assegnato sul corpo {0} non si chiude: il lato mancante è la risultante {1}, "
            "la cui retta si ha dai momenti."},
        Row{Sentence::resultant_couple, "The polygon of what is given on body {0} closes, but the couple {1} is left "
                                        "over.",
            "Il poligono di ciò che è assegnato sul corpo {0} si chiude, ma resta la coppia {1}."},
        Row{Sentence::truss_whole,
            "A truss of {0} bars and {1} pins: bars pinned at both ends and loaded at their pins carry a force along "
            "themselves only. It is cut free whole first: its reactions.",
            "Travatura reticolare di {0} aste e {1} nodi: le aste, incernierate agli estremi e caricate nei soli "
            "nodi, sono soggette a solo sforzo assiale. Dapprima la si isola per intero: le reazioni."},
        Row{Sentence::structure_whole,
            "Bodies {0} hang on the frame with as few unknowns as there are equations: they are cut free as one first.",
            "I corpi {0} sono vincolati al telaio con tante incognite quante equazioni: dapprima li si isola tutti "
            "insieme."},
        Row{Sentence::truss_idle_pair,
            "Pin {0} bears no load and joins two bars that are not in line: {1} and {2} carry nothing.",
            "Il nodo {0} è scarico e unisce due aste non allineate: {1} e {2} sono scariche."},
        Row{Sentence::truss_idle_third,
            "Pin {0} bears no load, and {2} and {3} are in line: the third bar, {1}, carries nothing.",
            "Il nodo {0} è scarico, {2} e {3} sono allineate: la terza asta, {1}, è scarica."},
        Row{Sentence::truss_idle_single, "At the unloaded pin {0} bar {1} has nothing to balance it: it carries "
                                         "nothing.",
            "Nel nodo scarico {0} nulla può equilibrare l’asta {1}: è scarica."},
        Row{Sentence::truss_stuck,
            "Every pin left has more than two unknown bars: a cut through {0} leads on.",
            "Tutti i nodi rimasti hanno più di due aste incognite: si prosegue con una sezione delle aste {0}."},
        Row{Sentence::truss_cut_moment,
            "Cut through {0}: {2} and {3} meet in {4}, so the moments about {4} of what acts on one side give {1} "
            "(Ritter).",
            "Sezione di {0}: {2} e {3} si incontrano in {4}, quindi i momenti rispetto a {4} di ciò che agisce su "
            "una parte danno {1} (Ritter)."},
        Row{Sentence::truss_cut_across,
            "Cut through {0}: {2} and {3} are parallel, so the equilibrium of one side across them gives {1} (Ritter).",
            "Sezione di {0}: {2} e {3} sono parallele, quindi l’equilibrio di una parte nella direzione normale ad "
            "esse dà {1} (Ritter)."},
        Row{Sentence::truss_plan,
            "The spaces {0} between the forces from outside are lettered clockwise (Bow); the forces, laid off in "
            "that order, close and begin Cremona’s diagram.",
            "Gli spazi {0} tra le forze esterne sono contrassegnati in senso orario (notazione di Bow); le forze, "
            "riportate in quest’ordine, chiudono il poligono con cui inizia il diagramma di Cremona."},
        Row{Sentence::truss_pin,
            "At pin {0} the polygon closes with {1}[: tension in {2}][; compression in {3}][; nothing in {4}].",
            "Nel nodo {0} il poligono si chiude con {1}[: trazione in {2}][; compressione in {3}][; nulla in {4}]."},
        Row{Sentence::truss_support, "At pin {0} all bars are known: the polygon closes with the reaction {1}.",
            "Nel nodo {0} tutte le aste sono note: il poligono si chiude con la reazione {1}."},
        Row{Sentence::truss_bar_and_support,
            "At pin {0} the polygon closes with bar {1} and the reaction {2}.",
            "Nel nodo {0} il poligono si chiude con l’asta {1} e la reazione {2}."},
        Row{Sentence::truss_closes, "At {0} all forces are known already, and the polygon closes: nothing was lost "
                                    "on the way.",
            "In {0} tutte le forze sono già note e il poligono si chiude: è una verifica."},
        Row{Sentence::residual_couple,
            "The joints of body {0} leave it free to turn about {2}. About {2} the resultant {1} of what is given "
            "has the moment {3}: it is not in equilibrium.",
            "I vincoli lasciano al corpo {0} la rotazione intorno a {2}. Rispetto a {2} la risultante {1} di ciò che "
            "è assegnato ha momento {3}: il corpo non è in equilibrio."},
        Row{Sentence::residual_force,
            "The joints of body {0} leave it free to go along a guide. Of the resultant {1} of what is given {2} "
            "acts along it: it is not in equilibrium.",
            "I vincoli lasciano al corpo {0} la traslazione lungo una guida. Della risultante {1} di ciò che è "
            "assegnato {2} agisce lungo di essa: il corpo non è in equilibrio."},
        Row{Sentence::moments_alone,
            "Of the unknown forces on body {0} only {2} has a moment about {1}, so the moments about {1} give it: it "
            "is the same in every equilibrium.",
            "Fra le forze incognite sul corpo {0} solo {2} ha momento rispetto a {1}, quindi la dà l’equilibrio dei "
            "momenti rispetto a {1}: è la stessa in ogni stato di equilibrio."},
        Row{Sentence::components_alone,
            "Of the unknown forces on body {0} only {1} has a component along its line, so the components along it "
            "give it: it is the same in every equilibrium.",
            "Fra le forze incognite sul corpo {0} solo {1} ha componente lungo la propria retta, quindi la danno le "
            "componenti secondo tale direzione: è la stessa in ogni stato di equilibrio."},
        Row{Sentence::translation_alone,
            "Body {0} has a virtual translation[ {2}] in which, of the unknown forces on it, only {1} does work, so "
            "the components in this direction give it: it is the same in every equilibrium.",
            "Il corpo {0} ha una traslazione virtuale[ {2}] in cui, fra le forze incognite su di esso, solo {1} compie "
            "lavoro, quindi la danno le componenti secondo questa direzione: è la stessa in ogni stato di equilibrio."},
        Row{Sentence::virtual_work_alone,
            "In this virtual motion, of the unknown forces, only {0} does work[: {1|body|bodies} {1} {1|turns|turn} "
            "about {2}][; {3|body|bodies} {3} {3|translates|translate}][; {4}]. The works of {0} and of the loads "
            "add up to zero: {0} is the same in every equilibrium.",
            "In questo moto virtuale, fra le forze incognite, solo {0} compie lavoro[: {1|il corpo|i corpi} {1} "
            "{1|ruota|ruotano} intorno a {2}][; {3|il corpo|i corpi} {3} {3|trasla|traslano}][; {4}]. I lavori di "
            "{0} e dei carichi hanno somma nulla: {0} è la stessa in ogni stato di equilibrio."},
        Row{Sentence::elimination_alone,
            "Elimination in the {1} equilibrium equations of body {0} leaves equations with one unknown each: {2} "
            "{2|is|are} the same in every equilibrium.",
            "L’eliminazione nelle {1} equazioni di equilibrio del corpo {0} lascia equazioni con una sola incognita: "
            "{2} {2|è la stessa|sono le stesse} in ogni stato di equilibrio."},
        Row{Sentence::no_force, "Nothing is left on body {0} for {1} to balance: {1}~=~0.",
            "Sul corpo {0} non resta nulla che {1} debba equilibrare: {1}~=~0."},
        Row{Sentence::no_force_along,
            "The known forces on body {0} are parallel to {2}, which balances them alone: {1}~=~0[; the couple "
            "{3}~=~0 too].",
            "Le forze note sul corpo {0} sono parallele a {2}, che da sola le equilibra: {1}~=~0[; anche la coppia "
            "{3}~=~0]."},
        Row{Sentence::act_given, "{0} is given: set it off from the pole.", "{0} è assegnata: si riporta dal polo."},
        Row{Sentence::act_projections,
            "{0} keeps its length, so the velocities of its ends must project alike on it: {1} and {2} do.",
            "{0} non cambia lunghezza, quindi le velocità dei suoi estremi devono avere uguale proiezione su di "
            "esso: per {1} e {2} è così."},
        Row{Sentence::act_projections_acceleration,
            "On {0} the projections of {1} and {2} differ by the normal part, {3}² {0}, as a rigid body asks.",
            "Su {0} le proiezioni di {1} e {2} differiscono della parte normale, {3}² {0}, come vuole il corpo "
            "rigido."},
        Row{Sentence::act_direction,
            "{3} and {1} project alike on {2}: the normal to {2} at the tip of {3} meets the given line of {1} in {0}.",
            "{3} e {1} hanno uguale proiezione su {2}: la normale a {2} per l’estremo di {3} incontra la retta "
            "assegnata di {1} in {0}."},
        Row{Sentence::act_direction_acceleration,
            "From the tip of {3} set off ω²~{2} along {2}, then the normal to {2}: it meets the given line of {1} in "
            "{0}.",
            "Dall’estremo di {3} si porta ω²~{2} lungo {2}, poi la normale a {2}: incontra la retta assegnata di {1} "
            "in {0}."},
        Row{Sentence::act_unequal_projections,
            "On {0} {1} projects to {3}, {2} to {4}: the length of {0} would change. No rigid body moves so.",
            "Su {0} la proiezione di {1} è {3}, quella di {2} è {4}: la lunghezza di {0} cambierebbe. Nessun corpo "
            "rigido si muove così."},
        Row{Sentence::act_unequal_projections_acceleration,
            "On {0} the projections of {1} and {2} do not differ by ω²~{0}: no rigid body has these accelerations.",
            "Su {0} le proiezioni di {1} e {2} non differiscono di ω²~{0}: nessun corpo rigido ha queste "
            "accelerazioni."},
        Row{Sentence::act_misses, "{0} is given otherwise than the rest lets it be: no rigid body moves so.",
            "{0} è assegnata diversa da quella che il resto impone: nessun corpo rigido si muove così."},
        Row{Sentence::act_agrees, "{0} is given too, and is the one that follows from the others.",
            "Anche {0} è assegnata, e coincide con quella che segue dalle altre."},
        Row{Sentence::act_perpendiculars,
            "A point moves normal to its join with the centre: the perpendiculars at {1} and {2} meet in {0}.",
            "Ogni punto si muove normalmente alla congiungente con il CIR: le perpendicolari in {1} e {2} si "
            "incontrano in {0}."},
        Row{Sentence::act_tips,
            "{1} and {2} are parallel and normal to {3}; speeds grow with the distance from the centre, so the join "
            "of the tips meets {3} in {0}.",
            "{1} e {2} sono parallele e normali a {3}; i moduli crescono con la distanza dal CIR: la congiungente "
            "gli estremi incontra {3} in {0}."},
        Row{Sentence::act_point_at_rest, "{1} is at rest, so it is the centre {0}.", "{1} è fermo: è il centro {0}."},
        Row{Sentence::act_translation, "{1} and {2} are equal, so ω = 0: body {0} translates and its centre is at "
                                       "infinity.",
            "{1} e {2} sono uguali, quindi ω = 0: il corpo {0} trasla e il suo CIR è all’infinito."},
        Row{Sentence::act_parallels,
            "The perpendiculars at {1} and {2} are parallel: the centre is at infinity, body {0} translates and ω = 0.",
            "Le perpendicolari in {1} e {2} sono parallele: il CIR è all’infinito, il corpo {0} trasla e ω = 0."},
        Row{Sentence::act_rest, "Two points of body {0} are at rest, so all of it is: every point may serve as its "
                                "centre.",
            "Due punti del corpo {0} sono fermi, quindi è tutto fermo: ogni punto può fare da CIR."},
        Row{Sentence::act_rest_by_lines,
            "The perpendicular at {1} misses the centre that the other directions want: body {0} can only be at rest.",
            "La perpendicolare in {1} non passa per il centro che le altre direzioni richiedono: il corpo {0} può "
            "solo essere fermo."},
        Row{Sentence::act_velocity,
            "{0} is normal to the ray from {2} to {1} and its size is {3} times the ray; the image gives the same.",
            "{0} è normale al raggio da {2} a {1} e vale {3} per il raggio; l’immagine dà lo stesso."},
        Row{Sentence::act_acceleration_centre,
            "{0} has no acceleration; that of every other point makes the angle arctan(α/ω²) with its join to {0}.",
            "{0} ha accelerazione nulla; quella di ogni altro punto forma con la congiungente a {0} l’angolo "
            "arctan(α/ω²)."},
        // curvature
        Row{Sentence::curvature_turning,
            "Body {0} turns about {1}, which rests: {1} is the centre of curvature of all its paths.",
            "Il corpo {0} ruota attorno a {1}, che è fermo: {1} è il centro di curvatura di tutte le sue traiettorie."},
        Row{Sentence::curvature_translation,
            "Body {0} translates at this instant: its pole is at infinity and there is no inflection circle.",
            "Il corpo {0} in questo istante trasla: il polo è all’infinito e non c’è cerchio dei flessi."},
        Row{Sentence::curvature_rest, "Body {0} stands still at this instant.", "Il corpo {0} in questo istante è "
            "fermo."},
        Row{Sentence::curvature_rays,
            "The rays {1} and {2}, each from a point to the centre of curvature of its path, meet in the pole {0}.",
            "I raggi {1} e {2}, ciascuno da un punto al centro di curvatura della sua traiettoria, si incontrano nel "
            "polo "
            "{0}."},
        Row{Sentence::curvature_pole, "The pole {0} lies on the normal to the velocity of {1}, at the distance "
                                      "{2}/{3}.",
            "Il polo {0} sta sulla normale alla velocità di {1}, alla distanza {2}/{3}."},
        Row{Sentence::curvature_bobillier,
            "The join of {0} with the meet {5} of {1} and {2} makes with the ray {4} the angle that the ray {3} "
            "makes with "
            "the pole tangent.",
            "La congiungente di {0} con l’intersezione {5} di {1} e {2} forma con il raggio {4} l’angolo che il "
            "raggio {3} "
            "forma con la tangente polare."},
        Row{Sentence::curvature_bobillier_at_infinity,
            "Both centres are at infinity: the parallel to {1} through {0} makes with the ray {3} the angle that the "
            "ray "
            "{2} makes with the pole tangent.",
            "I due centri sono all’infinito: la parallela a {1} per {0} forma con il raggio {3} l’angolo che il "
            "raggio {2} "
            "forma con la tangente polare."},
        Row{Sentence::curvature_inflection,
            "On the ray of {1} set off {1}{0}²/{1}{2} from {1} towards {2}; the normal to the ray at its end meets "
            "the pole "
            "normal in {3}: {0}{3} is the diameter of the inflection circle.",
            "Sul raggio di {1} si riporta {1}{0}²/{1}{2} da {1} verso {2}; la normale al raggio nell’estremo "
            "incontra la "
            "normale polare in {3}: {0}{3} è il diametro del cerchio dei flessi."},
        Row{Sentence::curvature_inflection_straight,
            "The path of {1} is straight, so {1} lies on the inflection circle; the normal to its ray there meets "
            "the pole "
            "normal in {2}: {0}{2} is the diameter.",
            "La traiettoria di {1} è rettilinea, quindi {1} sta sul cerchio dei flessi; la normale al raggio in {1} "
            "incontra la normale polare in {2}: {0}{2} è il diametro."},
        Row{Sentence::curvature_by_acceleration,
            "The acceleration of the body’s point in {0}, divided by {2}², leads from {0} to {1}: this is the "
            "diameter of "
            "the inflection circle, and the pole tangent is normal to it.",
            "L’accelerazione del punto del corpo in {0}, divisa per {2}², porta da {0} a {1}: è il diametro del "
            "cerchio dei "
            "flessi, e la tangente polare gli è normale."},
        Row{Sentence::curvature_bresse,
            "Bresse’s second circle (no tangential acceleration) has the diameter {1}{3} on the pole tangent; the "
            "foot of "
            "{1} on {2}{3} is on both circles: {0}, the acceleration pole.",
            "Il secondo cerchio di Bresse (accelerazione tangenziale nulla) ha il diametro {1}{3} sulla tangente "
            "polare; il "
            "piede di {1} su {2}{3} sta sui due cerchi: {0}, il polo delle accelerazioni."},
        Row{Sentence::curvature_bresse_uniform,
            "Body {1} turns uniformly: Bresse’s second circle is the pole normal, and {0} is the acceleration pole.",
            "Il corpo {1} ruota uniformemente: il secondo cerchio di Bresse è la normale polare e {0} è il polo delle "
            "accelerazioni."},
        Row{Sentence::curvature_hartmann,
            "Hartmann: the join of the tip of the velocity of {0} with that of the part, parallel to it, of the "
            "velocity "
            "with which the pole {2} moves on meets the ray in {1}.",
            "Hartmann: la congiungente l’estremo della velocità di {0} con quello della parte, ad essa parallela, "
            "della "
            "velocità con cui si sposta il polo {2} incontra il raggio in {1}."},
        Row{Sentence::curvature_straight, "{0} lies on the inflection circle: its path is straight to the second "
                                          "order.",
            "{0} sta sul cerchio dei flessi: la sua traiettoria è rettilinea fino al secondo ordine."},
        Row{Sentence::curvature_at_pole, "{0} lies in the pole: it stands still at this instant.",
            "{0} sta nel polo: in questo istante è fermo."},
        Row{Sentence::curvature_by_normal, "Of {0} the normal acceleration gives {1}, at v²/a on the normal to its "
                                           "velocity.",
            "Di {0} l’accelerazione normale dà {1}, a v²/a sulla normale alla velocità."},
        Row{Sentence::curvature_by_normal_straight, "{0} has no normal acceleration: its path is straight to the "
                                                    "second order.",
            "{0} non ha accelerazione normale: la sua traiettoria è rettilinea fino al secondo ordine."},
        Row{Sentence::curvature_envelope,
            "The line of {0} touches its envelope in the foot of {2}; on this normal the centre of curvature {1} lies "
            "opposite the point of the inflection circle.",
            "La retta di {0} tocca il suo inviluppo nel piede di {2}; su questa normale il centro di curvatura {1} sta "
            "dalla parte opposta del punto del cerchio dei flessi."},
        // remarks
        Row{Sentence::off_its_circle, "{0} is {1} off the circle of body {2} and is taken as drawn.",
            "{0} dista {1} dalla circonferenza del corpo {2} e resta dov’è disegnato."},
        Row{Sentence::off_its_foot,
            "{0} is {1} off the foot of {2} on the line; several joints claim it, so it is taken as drawn.",
            "{0} dista {1} dal piede di {2} sulla retta; più coppie lo impiegano, quindi resta dov’è disegnato."},
        Row{Sentence::off_its_centres,
            "{0} is {1} off the line of the centres {2} and {3}; several joints claim it, so it is taken as drawn.",
            "{0} dista {1} dalla retta dei centri {2} e {3}; più coppie lo impiegano, quindi resta dov’è disegnato."},
        Row{Sentence::moved_to_foot, "{0} was moved by {1} to the foot of {2} on the line.",
            "{0} è stato spostato di {1} nel piede di {2} sulla retta."},
        Row{Sentence::moved_to_centres, "{0} was moved by {1} to the line of the centres {2} and {3}.",
            "{0} è stato spostato di {1} sulla retta dei centri {2} e {3}."},
        Row{Sentence::taken_as_rounded,
            "Coordinates of 15 digits or more: the data are taken as rounded to {0}, unless \"precision\" says "
            "otherwise.",
            "Coordinate di 15 cifre o più: i dati si intendono arrotondati a {0}, se \"precision\" non dice altro."},
        Row{Sentence::nearly_on_line,
            "{0} lies only {2} off the line {1}, and the result hangs on that; if it is meant to lie on it, "
            "construct it there (\"from\", \"to\" or a \"meet\").",
            "{0} dista solo {2} dalla retta {1}, e il risultato ne dipende; se deve starvi, va costruito su di essa "
            "(\"from\", \"to\" o un \"meet\")."},
        Row{Sentence::nearly_parallel,
            "The lines {0} and {1} are only {2} from parallel, and the result hangs on that; if they are meant to be "
            "parallel, construct one (\"meet\" with a line \"parallel\" to the other).",
            "Le rette {0} e {1} sono a soli {2} dal parallelismo, e il risultato ne dipende; se devono essere "
            "parallele, se ne costruisca una (\"meet\" con una retta \"parallel\" all’altra)."},
        Row{Sentence::nearly_coincident,
            "{0} and {1} lie only {2} apart, and the result hangs on that; if they are meant to be one point, give "
            "it one name.",
            "{0} e {1} distano solo {2}, e il risultato ne dipende; se devono essere un solo punto, gli si dia un "
            "solo nome."},
        Row{Sentence::nearly_repeated,
            "Joint {0} all but repeats constraints of the others, and the mobility hangs on that; if it is meant to "
            "repeat them, construct its point from the others or state the \"precision\".",
            "La coppia {0} quasi ripete vincoli delle altre, e la mobilità ne dipende; se deve ripeterli, si "
            "costruisca il suo punto dagli altri o si dichiari \"precision\"."},
        Row{Sentence::is_ill_conditioned, "{0} changes by {1} if {2} moves by {3}.",
            "{0} varia di {1} se {2} si sposta di {3}."},
        Row{Sentence::repeated_constraints,
            "Joint {0} repeats {1} {1|constraint|constraints} that the others impose already at this position.",
            "La coppia {0} ripete {1} {1|vincolo|vincoli} che le altre impongono già in questa configurazione."},
        Row{Sentence::link_without_length, "Link {0} has no length: its pins {1} lie at one place.",
            "Il corpo {0} non ha lunghezza: i suoi perni {1} coincidono."},
        Row{Sentence::strange_gravity, "Gravity is {0}, as on no planet; if that is not meant, write it with its "
                                       "unit: \"9.81 m/s²\".",
            "La gravità è {0}, come su nessun pianeta; se non è voluto, scriverla con l’unità: \"9.81 m/s²\"."},
        Row{Sentence::lift_off, "The contact at {0} would have to pull: there the bodies lift off.",
            "Il contatto in {0} dovrebbe tirare: lì i corpi si staccano."},
        Row{Sentence::change_point,
            "Change point: {0} {0|freedom|freedoms} at this position for {1} of the count; to the second order {2} "
            "{2|branch leaves|branches leave} it.",
            "Punto di diramazione: {0} {0|grado|gradi} di libertà in questa configurazione contro {1} del computo; "
            "al secondo ordine ne {2|parte|partono} {2} {2|ramo|rami}."},
        Row{Sentence::branch, "Branch {0}: {1}.", "Ramo {0}: {1}."},
        Row{Sentence::branch_without_turning, "Branch {0}: no body turns.", "Ramo {0}: nessun corpo ruota."},
        Row{Sentence::instant_only,
            "The position moves for an instant only: {0} {0|freedom|freedoms} by the rank, to which no accelerations "
            "belong.",
            "La configurazione è mobile solo per un istante: {0} {0|grado|gradi} di libertà secondo il rango, cui "
            "non corrispondono accelerazioni."},
        Row{Sentence::bound_velocities,
            "The position has {0} freedoms for an instant; {1} second-order {1|condition binds|conditions bind} its "
            "velocities, so that not all of them can leave it.",
            "La configurazione ha {0} gradi di libertà per un istante; {1} {1|condizione|condizioni} del secondo "
            "ordine {1|vincola|vincolano} le velocità: non tutte possono uscirne."},
        Row{Sentence::nothing_moves,
            "Nothing moves in this position: any two bodies are at rest against each other, and every point may serve "
            "as their instant centre.",
            "In questa configurazione nulla si muove: due corpi qualsiasi sono fermi l’uno rispetto all’altro e ogni "
            "punto può fare da loro centro di istantanea rotazione."},
        Row{Sentence::still_bodies,
            "{0|Body|Bodies} {0} {0|stands|stand} still in every motion that this position allows and cannot be "
            "driven here.",
            "{0|Il corpo|I corpi} {0} {0|resta fermo|restano fermi} in ogni moto possibile in questa configurazione "
            "e non {0|può|possono} essere {0|comandato|comandati}."},
        Row{Sentence::unturning_bodies,
            "{0|Body|Bodies} {0} {0|does|do} not turn in any motion that this position allows: no angular velocity "
            "can be driven there.",
            "{0|Il corpo|I corpi} {0} non {0|ruota|ruotano} in alcun moto possibile in questa configurazione: la "
            "velocità angolare non può essere assegnata."},
        Row{Sentence::freedoms_without_driver,
            "{0} {0|freedom|freedoms} in this position, of which the drivers determine {1}: the motion of the rest is "
            "open; give a driver for each.",
            "{0} {0|grado|gradi} di libertà in questa configurazione, di cui i moventi ne determinano {1}: il moto del "
            "resto è indeterminato; assegnare un movente per ciascuno."},
        Row{Sentence::drivers_without_freedom,
            "{1} {1|driver|drivers} for {0} {0|freedom|freedoms} in this position: not all of them can be given; take "
            "out what the others determine.",
            "{1} {1|movente|moventi} per {0} {0|grado|gradi} di libertà in questa configurazione: non si possono "
            "assegnare tutti; togliere ciò che gli altri determinano."},
        Row{Sentence::freedoms_without_effort,
            "{0} {0|freedom|freedoms} in this position and {1} input {1|force or couple|forces or couples}: "
            "equilibrium needs one for each freedom.",
            "{0} {0|grado|gradi} di libertà in questa configurazione e {1} {1|azione motrice|azioni motrici}: "
            "l’equilibrio ne richiede una per ogni grado di libertà."},
        Row{Sentence::efforts_without_freedom,
            "{1} input {1|force or couple|forces or couples} for {0} {0|freedom|freedoms} in this position: "
            "equilibrium does not determine all of them.",
            "{1} {1|azione motrice|azioni motrici} per {0} {0|grado|gradi} di libertà in questa configurazione: "
            "l’equilibrio non le determina tutte."},
        Row{Sentence::body_without_joint, "Body {0} has no joint, so nothing holds it; give it one[, perhaps {1}].",
            "Il corpo {0} non ha coppie: nulla lo trattiene; assegnargliene una[, forse {1}]."},
        Row{Sentence::body_of_one_joint,
            "Body {0} has one joint only, {1}, and nothing else holds or drives it; give it another[, perhaps {2}].",
            "Il corpo {0} ha una sola coppia, {1}, e nient’altro lo trattiene o lo comanda; assegnargliene "
            "un’altra[, forse {2}]."},
        Row{Sentence::unjoined_pin,
            "Bodies {0} and {1} meet in {2}[, where {3} lies too], but no joint joins them there; if they are "
            "pinned, add {4}.",
            "I corpi {0} e {1} si incontrano in {2}[, dove sta anche {3}], ma nessuna coppia li unisce lì; se c’è "
            "una cerniera, aggiungere {4}."},
        Row{Sentence::off_the_frame, "No joint connects bodies {0} with the frame, {1}; give the one that does[, "
                                     "perhaps {2}].",
            "Nessuna coppia collega i corpi {0} al telaio, {1}; assegnare quella che manca[, forse {2}]."},
        Row{Sentence::rounded_givens,
            "Numbers of {0} digits are given; points are rounded to {1} digits of the drawing’s size, as the compass "
            "rounds.",
            "I dati hanno {0} cifre; i punti sono arrotondati a {1} cifre della grandezza del disegno, come fa il "
            "compasso."},
        Row{Sentence::check_differs,
            "The numeric check does not confirm {0}: {1} by the construction, off by {2}[; nor {3} more of its kind].",
            "La verifica numerica non conferma {0}: {1} dalla costruzione, con uno scarto di {2}[; né {3} "
            "{3|altra|altre} dello stesso tipo]."},
        Row{Sentence::check_stands_still,
            "By the construction body {0} moves; the numeric check finds its motion not determined.",
            "Per la costruzione il corpo {0} si muove; per la verifica numerica il suo moto non è determinato."},
        Row{Sentence::check_moves, "By the numeric check body {0} moves; by the construction its motion is not "
                                   "determined.",
            "Per la verifica numerica il corpo {0} si muove; per la costruzione il suo moto non è determinato."},
        Row{Sentence::truss_without_order,
            "No order of pins with two unknown bars at most and no cut through three resolves this truss of {0} "
            "bars: they are cut free one by one.",
            "Nessun ordine dei nodi con al più due aste incognite e nessuna sezione di tre aste risolve questa "
            "travatura di {0} aste: le si isola una per una."},
        Row{Sentence::truss_without_plan,
            "Of the truss’s {0} bars some cross, or a force acts inside it: there is no Cremona diagram in one figure.",
            "Tra le {0} aste alcune si incrociano, o vi sono forze applicate all’interno della travatura: non esiste "
            "un diagramma di Cremona unico."},
        // what is not determined
        Row{Sentence::motion_of_body, "motion of body {0}", "moto del corpo {0}"},
        Row{Sentence::velocity_of_body, "velocity of body {0}", "velocità del corpo {0}"},
        Row{Sentence::acceleration_of_body, "acceleration of body {0}", "accelerazione del corpo {0}"},
        Row{Sentence::drive_of_joint, "driver of joint {0}", "movente della coppia {0}"},
        Row{Sentence::drive_of_body, "driver of body {0}", "movente del corpo {0}"},
        Row{Sentence::centre_of_bodies, "instant centre {0},{1}", "centro di istantanea rotazione {0},{1}"},
        Row{Sentence::curvature_of_body, "curvature of body {0}", "curvatura del corpo {0}"},
        Row{Sentence::all_forces, "forces", "forze"},
        // and why not
        Row{Sentence::one_body_only, "an act of motion is of one body, here {0}", "un atto di moto è di un solo "
            "corpo, qui {0}"},
        Row{Sentence::velocities_contradict, "the velocities contradict each other", "le velocità si contraddicono"},
        Row{Sentence::unequal_projections,
            "no rigid motion has these velocities: on {0} that of {1} projects to {2}, that of {3} to {4}",
            "nessun moto rigido ha queste velocità: su {0} quella di {1} ha proiezione {2}, quella di {3} {4}"},
        Row{Sentence::unequal_normal_parts, "no rigid motion has these accelerations: the projections of those of "
                                            "{0} and {1} on their join do not differ by ω² times their distance",
            "nessun moto rigido ha queste accelerazioni: le proiezioni di quelle di {0} e {1} sulla "
            "congiungente non differiscono di ω² per la distanza"},
        Row{Sentence::two_velocities_at_one_place,
            "{0} and {1} are at one place of the body and cannot have different velocities",
            "{0} e {1} sono nello stesso luogo del corpo e non possono avere velocità diverse"},
        Row{Sentence::two_accelerations_at_one_place,
            "{0} and {1} are at one place of the body and cannot have different accelerations",
            "{0} e {1} sono nello stesso luogo del corpo e non possono avere accelerazioni diverse"},
        Row{Sentence::velocity_misses,
            "the velocity given at {0} is not the one that the body has there by those of the other points",
            "la velocità assegnata in {0} non è quella che il corpo ha lì secondo gli altri punti"},
        Row{Sentence::acceleration_misses,
            "the acceleration given at {0} is not the one that the body has there by those of the other points",
            "l’accelerazione assegnata in {0} non è quella che il corpo ha lì secondo gli altri punti"},
        Row{Sentence::no_velocity_given, "no velocity is given", "nessuna velocità è assegnata"},
        Row{Sentence::no_acceleration_given, "no acceleration is given", "nessuna accelerazione è assegnata"},
        Row{Sentence::centre_on_perpendicular,
            "it lies on the perpendicular to the velocity of {0}, and nothing given says where on it",
            "sta sulla perpendicolare alla velocità di {0}, e nulla di assegnato dice dove"},
        Row{Sentence::speed_of_translation_open,
            "directions alone say that it translates, not how fast; give the velocity of one point",
            "le sole direzioni dicono che trasla, non con quale velocità; assegnare quella di un punto"},
        Row{Sentence::size_open, "centre and directions are known, no size; give the velocity of a point that moves",
            "centro e direzioni sono noti, nessun modulo; assegnare la velocità di un punto che si muove"},
        Row{Sentence::turning_open,
            "what is given leaves the turning of the body free; give the velocity of another point, or its direction",
            "quanto assegnato lascia libera la rotazione del corpo; assegnare la velocità di un altro punto, o la "
            "sua direzione"},
        Row{Sentence::omega_unknown, "the angular velocity, which the normal parts ω²·r want, is not known",
            "la velocità angolare, richiesta dalle parti normali ω²·r, non è nota"},
        Row{Sentence::acceleration_open, "what is given leaves it free; give the acceleration of another point, or "
                                         "its direction",
            "quanto assegnato la lascia libera; assegnare l’accelerazione di un altro punto, o la sua direzione"},
        Row{Sentence::path_straight, "its path is straight to the second order",
            "la sua traiettoria è rettilinea fino al secondo ordine"},
        Row{Sentence::point_at_rest, "it stands still at this instant", "in questo istante è fermo"},
        Row{Sentence::body_translates, "it translates: its pole is at infinity", "trasla: il suo polo è all’infinito"},
        Row{Sentence::body_at_rest, "it stands still at this instant", "in questo istante è fermo"},
        Row{Sentence::pole_at_rest, "its pole rests and has no tangent", "il suo polo è fermo e non ha tangente"},
        Row{Sentence::locked, "the mechanism is locked in this position: it has no freedom left to drive",
            "il meccanismo è bloccato in questa configurazione: non resta alcun grado di libertà da comandare"},
        Row{Sentence::undrivable,
            "it cannot be driven here: a dead point; what it drives stands still whatever the rest does, and the "
            "motion of the rest stays free",
            "qui non può essere comandato: punto morto; ciò che comanda è fermo comunque si muova il resto, il cui "
            "moto rimane libero"},
        Row{Sentence::driven_otherwise, "the other drivers fix this motion already, and differently",
            "gli altri moventi fissano già questo moto, e in modo diverso"},
        Row{Sentence::no_rigid_motion,
            "no rigid motion has these velocities: those of {0} and {1} have different projections on their join",
            "nessun moto rigido ha queste velocità: quelle di {0} e {1} hanno proiezioni diverse sulla loro "
            "congiungente"},
        Row{Sentence::hangs_on_undetermined, "it depends on bodies whose motion is not determined",
            "dipende da corpi il cui moto non è determinato"},
        Row{Sentence::curvatures_coincide,
            "at {0} both profiles have one centre of curvature, which leaves the accelerations open",
            "in {0} i due profili hanno lo stesso centro di curvatura, il che lascia libere le accelerazioni"},
        Row{Sentence::curvatures_wanted, "it needs the curvatures at {0}; give the profiles of both bodies there",
            "servono le curvature in {0}; assegnare lì i profili dei due corpi"},
        Row{Sentence::nothing_drives, "nothing drives the mechanism, which has {0} {0|freedom|freedoms}; give its "
                                      "drivers",
            "nulla muove il meccanismo, che ha {0} {0|grado|gradi} di libertà; assegnare i moventi"},
        Row{Sentence::stays_free, "it stays free: the driver moves nothing at this position (dead point)",
            "resta libero: in questa configurazione il movente non muove nulla (punto morto)"},
        Row{Sentence::dead_point_at, "dead point at {0}: the two lines on which its velocity must lie are parallel",
            "punto morto in {0}: le due rette su cui deve stare la sua velocità sono parallele"},
        Row{Sentence::lacks_drivers,
            "the mechanism has {0} {0|freedom|freedoms} and {1} of them driven{2|; give one driver more|}[; give {3} "
            "drivers more]",
            "il meccanismo ha {0} {0|grado|gradi} di libertà, di cui {1} {1|comandato|comandati}{2|; assegnare un "
            "movente in più|}[; assegnare {3} moventi in più]"},
        Row{Sentence::stands_still, "dead point: it can only stand still here, and no driver moves it",
            "punto morto: qui può solo stare fermo, e nessun movente lo muove"},
        Row{Sentence::beyond_groups,
            "it is determined, but neither a driven body, dyad or triad nor a trial of up to three unknowns at once "
            "leads to it",
            "è determinato, ma non vi portano né un corpo comandato, una diade o una triade, né valori di prova fino "
            "a tre incognite insieme"},
        Row{Sentence::one_line_undetermined,
            "the theorem of Aronhold and Kennedy gives one line at most, and the motion is not determined",
            "il teorema di Aronhold e Kennedy dà al più una retta, e il moto non è determinato"},
        Row{Sentence::one_line_unknown,
            "the theorem of Aronhold and Kennedy gives one line at most, and the bodies’ motion against each other "
            "is not known",
            "il teorema di Aronhold e Kennedy dà al più una retta, e il moto relativo dei due corpi non è noto"},
        Row{Sentence::spring_without_direction, "the ends of {0} coincide at this position: its pull has no direction",
            "gli estremi di {0} coincidono in questa configurazione: la sua forza non ha direzione"},
        Row{Sentence::inertia_without_motion,
            "the inertia forces of body {0} need its acceleration, which is not known; give the drivers",
            "le forze d’inerzia del corpo {0} richiedono la sua accelerazione, che non è nota; assegnare i moventi"},
        Row{Sentence::unbalanced,
            "the loads are not balanced: the mechanism has {0} {0|freedom|freedoms} and {1} {1|effort|efforts} to "
            "hold it; give one for each freedom[; not determined: {2}]",
            "i carichi non sono equilibrati: il meccanismo ha {0} {0|grado|gradi} di libertà e {1} {1|azione "
            "equilibrante|azioni equilibranti}; assegnarne una per ciascun grado di libertà[; non determinate: {2}]"},
        Row{Sentence::too_many_efforts,
            "{0} {0|effort stands|efforts stand} against {1} {1|freedom|freedoms}; give one for each freedom[; not "
            "determined: {2}]",
            "a {1} {1|grado|gradi} di libertà {0|corrisponde|corrispondono} {0} {0|azione equilibrante|azioni "
            "equilibranti}; assegnarne una per ciascuno[; non determinate: {2}]"},
        Row{Sentence::indeterminate,
            "statically indeterminate, {0} {0|time|times}: {1|joint|joints} {1} {1|repeats|repeat} what others hold "
            "already[; not determined: {2}]",
            "staticamente indeterminato, {0} {0|volta|volte}: {1|la coppia|le coppie} {1} {1|ripete|ripetono} "
            "vincoli già imposti da altre[; non determinate: {2}]"},
        Row{Sentence::effort_without_work,
            "the effort does no work in the motion that is free at this position: a dead point, where a force grows "
            "without limit[; not determined: {0}]",
            "l’azione equilibrante non compie lavoro nel moto libero in questa configurazione: un punto morto, dove "
            "una forza cresce senza limite[; non determinate: {0}]"},
        Row{Sentence::not_by_equilibrium, "equilibrium does not determine them at this position[; not determined: {0}]",
            "l’equilibrio non le determina in questa configurazione[; non determinate: {0}]"},
        Row{Sentence::cut_of_bars, "cut through {0}", "sezione di {0}"},
        Row{Sentence::cut_in_one_point,
            "the lines of the three bars meet in one point or are all parallel, so that no equation holds one of "
            "them alone; cut other bars",
            "le rette delle tre aste concorrono in un punto o sono tutte parallele: nessuna equazione ne contiene "
            "una sola; sezionare altre aste"},
        Row{Sentence::cut_without_reactions, "the reactions on either side of it are not known",
            "le reazioni sull’una e sull’altra parte non sono note"},
    };
// clang-format on

struct FixedWords {
    std::string_view key, en, it;
};
constexpr auto fixed_words = std::to_array<FixedWords>({
    // figures
    FixedWords{"figure", "Fig.", "Fig."},
    FixedWords{"mechanism", "Mechanism", "Meccanismo"},
    FixedWords{"without centres", ", without", ", senza"},
    FixedWords{"mechanism and instant centres", "Mechanism and instant centres",
               "Meccanismo e centri di istantanea rotazione"},
    FixedWords{"mechanism and its way", "Mechanism as drawn, and its motion", "Meccanismo come disegnato e suo moto"},
    FixedWords{"cam and follower", "Cam and follower", "Camma e punteria"},
    FixedWords{"base circle", "base circle", "circonferenza di base"},
    FixedWords{"pitch curve", "pitch curve", "curva primitiva"},
    FixedWords{"rise of the follower", "Rise of the follower", "Alzata della punteria"},
    FixedWords{"speed of the follower", "Velocity of the follower", "Velocità della punteria"},
    FixedWords{"acceleration of the follower", "Acceleration of the follower", "Accelerazione della punteria"},
    FixedWords{"pressure angle over the turn", "Pressure angle", "Angolo di pressione"},
    FixedWords{"rise angle", "β", "β"},
    FixedWords{"rise angle rate", "dβ/dt", "dβ/dt"},
    FixedWords{"rise angle acceleration", "d²β/dt²", "d²β/dt²"},
    FixedWords{"fixed centrode", "fixed centrode", "polare fissa"},
    FixedWords{"moving centrode", "moving centrode", "polare mobile"},
    FixedWords{"extremes of rows", "Extremes", "Estremi"},
    FixedWords{"extremes", "Extremes of the motion", "Valori estremi del moto"},
    FixedWords{"quantity", "quantity", "grandezza"},
    FixedWords{"least", "least", "minimo"},
    FixedWords{"greatest", "greatest", "massimo"},
    FixedWords{"at the position", "at", "a"},
    FixedWords{"mean", "mean", "media"},
    FixedWords{"without limit", "without limit", "senza limite"},
    FixedWords{"grows without limit at", "grows without limit at", "cresce senza limite a"},
    FixedWords{"separation", "lift-off of the contact", "distacco del contatto"},
    FixedWords{"stroke", "stroke", "corsa"},
    FixedWords{"limits of the driver", "limit positions of the driver", "posizioni limite del movente"},
    FixedWords{"change points", "change points (the branch is a choice)",
               "punti di biforcazione (il ramo è una scelta)"},
    FixedWords{"time ratio", "time ratio of slow and quick stroke", "rapporto dei tempi di andata e ritorno"},
    FixedWords{"least transmission angle", "least transmission angle", "minimo angolo di trasmissione"},
    FixedWords{"pressure angle", "pressure angle", "angolo di pressione"},
    FixedWords{"largest speed", "largest speed", "massima velocità"},
    FixedWords{"largest acceleration", "largest acceleration", "massima accelerazione"},
    FixedWords{"velocity polygon", "Velocity polygon", "Poligono delle velocità"},
    FixedWords{"acceleration polygon", "Acceleration polygon", "Poligono delle accelerazioni"},
    FixedWords{"velocities on the mechanism", "Velocities on the mechanism", "Velocità sul meccanismo"},
    FixedWords{"accelerations on the mechanism", "Accelerations on the mechanism", "Accelerazioni sul meccanismo"},
    FixedWords{"loops on the mechanism", "Vector loops on the mechanism", "Maglie vettoriali sul meccanismo"},
    FixedWords{"virtual displacements", "Virtual displacements for", "Spostamenti virtuali per"},
    FixedWords{"moving axes", "Moving axes on body", "Terna mobile sul corpo"},
    FixedWords{"curvature of body", "Curvature, body", "Curvatura, corpo"},
    // the live page
    FixedWords{"live play", "Play", "Avvia"},
    FixedWords{"live pause", "Pause", "Ferma"},
    FixedWords{"live as drawn", "As drawn", "Come disegnato"},
    FixedWords{"live driver", "Driver", "Movente"},
    FixedWords{"live position", "Position", "Posizione"},
    FixedWords{"live fit", "Polygons fill their room", "Poligoni adattati allo spazio"},
    FixedWords{"live previous", "Previous step", "Passo precedente"},
    FixedWords{"live next", "Next step", "Passo successivo"},
    FixedWords{"live all", "All steps", "Tutti i passi"},
    FixedWords{"live language", "Language", "Lingua"},
    FixedWords{"live theme", "Theme", "Tema"},
    FixedWords{"live theme system", "system", "di sistema"},
    FixedWords{"live theme light", "light", "chiaro"},
    FixedWords{"live theme dark", "dark", "scuro"},
    FixedWords{"live print", "Print", "Stampa"},
    FixedWords{"live limit", "Limit: the driver stops here; the mechanism is at a dead point.",
               "Limite: qui il movente si ferma; il meccanismo è in un punto morto."},
    FixedWords{"live change point",
               "Change point: the mechanism may go on along another branch, and velocities have no one answer.",
               "Punto di biforcazione: il meccanismo può proseguire su un altro ramo e le velocità non sono univoche."},
    FixedWords{"live no construction", "No construction was planned for this position: only places are shown.",
               "Per questa posizione non è prevista alcuna costruzione: si mostrano solo le posizioni."},
    FixedWords{"live not followed", "Shows the drawn position.", "Mostra la posizione disegnata."},
    FixedWords{"live of drawn position", "The numbers in the sentences are those of the drawn position.",
               "I numeri nelle frasi sono quelli della posizione disegnata."},
    FixedWords{"live step", "Step {0} of {1}", "Passo {0} di {1}"},
    FixedWords{"live out of reach", "The mechanism cannot be closed there.", "Lì il meccanismo non si chiude."},
    FixedWords{"live drawn", "as drawn", "come disegnato"},
    FixedWords{"live faults", "The file has faults; the page shows it as it was before.",
               "Il file contiene errori; la pagina lo mostra com’era prima."},
    FixedWords{"live faults at first", "The file has faults; the page appears as soon as it has none.",
               "Il file contiene errori; la pagina compare appena non ne ha più."},
    FixedWords{"live line", "Line {0}, column {1}", "Riga {0}, colonna {1}"},
    FixedWords{"live lost", "kinegraph watch does not answer any more; the page shows what it showed last.",
               "kinegraph watch non risponde più; la pagina mostra l’ultimo stato."},
    FixedWords{"live try", "Try it yourself", "Prova tu"},
    FixedWords{"live end trying", "End the exercise", "Termina l’esercizio"},
    FixedWords{"live nothing to try", "There is no polygon here to be drawn.", "Qui non c’è un poligono da disegnare."},
    FixedWords{"live polygon", "Polygon", "Poligono"},
    FixedWords{"live from", "From", "Da"},
    FixedWords{"live direction", "Direction", "Direzione"},
    FixedWords{"live by hand", "by hand", "a mano libera"},
    FixedWords{"live check", "Check", "Controlla"},
    FixedWords{"live hint", "Hint", "Suggerimento"},
    FixedWords{"live show it", "Show it", "Mostra"},
    FixedWords{"live score", "Score {0} of {1}", "Punti {0} su {1}"},
    FixedWords{"live draw vector", "Draw {0}: its point, direction, sense and length.",
               "Disegna {0}: punto, direzione, verso e lunghezza."},
    FixedWords{"live draw line", "Draw the next line: its point and direction.",
               "Disegna la prossima retta: punto e direzione."},
    FixedWords{"live draw line of", "Draw the line on which {0} lies: its point and direction.",
               "Disegna la retta su cui giace {0}: punto e direzione."},
    FixedWords{"live tip of", "tip of {0}", "estremo di {0}"},
    FixedWords{"live start", "starting point", "punto iniziale"},
    FixedWords{"live guide", "guide in {0}", "guida in {0}"},
    FixedWords{"live horizontal", "horizontal", "orizzontale"},
    FixedWords{"live vertical", "vertical", "verticale"},
    FixedWords{"live line end", "End of the line: drag it, or move it by the arrow keys",
               "Estremo della linea: trascinarlo, o spostarlo con le frecce"},
    FixedWords{"live wrong point", "It begins in the wrong point.", "Parte dal punto sbagliato."},
    FixedWords{"live wrong direction", "The direction is wrong.", "La direzione è sbagliata."},
    FixedWords{"live wrong sense", "The direction is right, the sense is wrong.",
               "La direzione è giusta, il verso è sbagliato."},
    FixedWords{"live too long", "Direction and sense are right, but it is too long.",
               "Direzione e verso sono giusti, ma è troppo lungo."},
    FixedWords{"live too short", "It is too short.", "È troppo corto."},
    FixedWords{"live right", "Right. Now the next one.", "Giusto. Ora il prossimo."},
    FixedWords{"live shown", "Here it is. Now the next one.", "Eccolo. Ora il prossimo."},
    FixedWords{"live all drawn", "The polygon is complete.", "Il poligono è completo."},
    FixedWords{"live no hint", "There is no sentence about this line.", "Nessuna frase parla di questa linea."},
    FixedWords{"live ruler", "Ruler", "Riga"},
    FixedWords{
        "live ruler end",
        "End of the ruler: drag it, or move it by the arrow keys; Page Down takes the ruler to the next figure",
        "Estremo della riga: trascinarlo, o spostarlo con le frecce; Pag giù porta la riga alla figura successiva"},
    FixedWords{"live values beside", "Values beside vectors", "Valori accanto ai vettori"},
    FixedWords{"live trace", "Path of", "Traiettoria di"},
    FixedWords{"live plot", "Plot", "Diagramma"},
    FixedWords{"live none", "none", "nessuno"},
    FixedWords{"live givens", "Given", "Dati"},
    FixedWords{"live does not close", "With this value the mechanism does not close; it stays as it was.",
               "Con questo valore il meccanismo non si chiude: resta com’era."},
    FixedWords{"live fixed otherwise",
               "In the file only, since the numbers do not follow from it as sums and products: {0}.",
               "Solo nel file, perché i numeri non ne seguono per somme e prodotti: {0}."},
    FixedWords{"live fixed nothing",
               "Not changed here, since it only says in which position the mechanism is drawn; the slider moves it to "
               "others: {0}.",
               "Non si cambia qui, perché dice soltanto in quale posizione è disegnato il meccanismo; la barra lo "
               "porta in altre: {0}."},
    FixedWords{"live fixed zero",
               "In the file only, since it is zero there and signs and parallels were judged by that: {0}.",
               "Solo nel file, dove è zero e ha deciso segni e parallelismi: {0}."},
    FixedWords{"live fixed many", "In the file only, since eight others can be changed here: {0}.",
               "Solo nel file, perché qui se ne possono cambiare altri otto: {0}."},
    FixedWords{"live values", "Values", "Valori"},
    FixedWords{"live column", "quantity", "grandezza"},
    FixedWords{"live value", "value", "valore"},
    FixedWords{"live still", "This driver cannot be moved", "Questo movente non si può muovere"},
    FixedWords{"steps curvature", "Steps: curvature", "Procedimento: curvatura"},
    FixedWords{"curvature", "Curvature", "Curvatura"},
    FixedWords{"act of motion", "Act of motion", "Atto di moto"},
    FixedWords{"circle diagram", "Circle diagram of the centres", "Diagramma circolare dei centri"},
    FixedWords{"detail", "Detail", "Particolare"},
    FixedWords{"relative velocity of", "Motion relative to", "Moto relativo a"},
    FixedWords{"seen from body", "seen from body", "rispetto al corpo"},
    FixedWords{"seen from axes translating with", "seen from axes translating with", "rispetto ad assi traslanti con"},
    FixedWords{"of", "of", "di"},
    FixedWords{"scale", "scale", "scala"},
    FixedWords{"guide", "guide", "guida"},
    FixedWords{"drive", "drive", "movente"},
    FixedWords{"locus", "locus", "luogo"},
    FixedWords{"tangent", "tangent", "tangente"},
    FixedWords{"known", "known", "nota"},
    FixedWords{"given line", "given line", "retta data"},
    // headings
    FixedWords{"bodies", "Bodies", "Corpi"},
    FixedWords{"body", "body", "corpo"},
    FixedWords{"frame", "frame", "telaio"},
    FixedWords{"instant centres", "Instant centres", "Centri di istantanea rotazione"},
    FixedWords{"absolute centre", "absolute", "CIR"},
    FixedWords{"results", "Results", "Risultati"},
    FixedWords{"continued", "continued", "seguito"},
    FixedWords{"on sheet", "sheet", "foglio"},
    FixedWords{"velocities", "Velocities", "Velocità"},
    FixedWords{"accelerations", "Accelerations", "Accelerazioni"},
    FixedWords{"relative motion", "Relative motion", "Moto relativo"},
    FixedWords{"steps", "Steps", "Procedimento"},
    FixedWords{"steps centres", "Steps: instant centres", "Procedimento: centri"},
    FixedWords{"steps velocity", "Steps: velocities", "Procedimento: velocità"},
    FixedWords{"steps acceleration", "Steps: accelerations", "Procedimento: accelerazioni"},
    FixedWords{"steps relative motion", "Steps: relative motion", "Procedimento: moto relativo"},
    FixedWords{
        "polygons joined",
        "Joined on their common sides the polygons close: the inner forces, drawn broken, cancel in pairs, and those "
        "from "
        "outside are in equilibrium.",
        "Accostati sui lati comuni i poligoni si chiudono: le forze interne, a tratti, si elidono a due a due e quelle "
        "esterne sono in equilibrio."},
    FixedWords{"remarks", "Remarks", "Osservazioni"},
    FixedWords{"scale refused", "at the scale that the file asks for it does not fit the sheet.",
               "alla scala richiesta dal file non sta nel foglio."},
    FixedWords{"names left out", "there is no room to read all names; left out are",
               "non c’è spazio per leggere tutti i nomi; mancano"},
    FixedWords{"unsolved", "Not determined", "Non determinato"},
    FixedWords{"a remark", "remark", "osservazione"},
    FixedWords{"one unsolved", "unsolved", "non determinato"},
    FixedWords{"mobility", "Mobility", "Mobilità"},
    FixedWords{"degrees of freedom", "degrees of freedom", "gradi di libertà"},
    FixedWords{"effective", "effective in this position", "effettivi in questa configurazione"},
    FixedWords{"effective one", "effective in this position", "effettivo in questa configurazione"},
    FixedWords{"by Grübler", "by Grübler", "secondo Grübler"},
    FixedWords{"at this pose", "the rank confirms it in this position",
               "il rango lo conferma in questa configurazione"},
    FixedWords{"verdict", "verdict", "giudizio"},
    FixedWords{"verdict mechanism", "mechanism", "meccanismo"},
    FixedWords{"verdict isostatic", "isostatic", "isostatico"},
    FixedWords{"verdict hyperstatic", "hyperstatic", "iperstatico"},
    FixedWords{"verdict labile", "labile in spite of the count", "labile nonostante il computo"},
    FixedWords{"time", "time", "volta"},
    FixedWords{"times", "times", "volte"},
    // the catalogue of pairs
    FixedWords{"catalogue of pairs", "Catalogue of pairs", "Catalogo delle coppie"},
    FixedWords{"pairs of the plane", "Pairs of the plane", "Coppie nel piano"},
    FixedWords{"lower pairs in space", "Lower pairs in space", "Coppie elementari nello spazio"},
    FixedWords{"multiple hinges", "Multiple hinges", "Cerniere multiple"},
    FixedWords{"pair revolute", "revolute pair (hinge)", "coppia rotoidale (cerniera)"},
    FixedWords{"pair prismatic", "prismatic pair (slider, sleeve)", "coppia prismatica (cursore, manicotto)"},
    FixedWords{"pair pin-slot", "pin in a slot", "perno in un glifo"},
    FixedWords{"pair rolling", "rolling without slip", "rotolamento senza strisciamento"},
    FixedWords{"pair contact", "sliding contact (cam, roller support)", "contatto con strisciamento (camma, carrello)"},
    FixedWords{"pair gear", "gear pair", "coppia di ruote dentate"},
    FixedWords{"pair weld", "clamped joint", "incastro"},
    FixedWords{"in the file", "file", "file"},
    FixedWords{"freedoms left", "freedoms left", "libertà residue"},
    FixedWords{"freedoms revolute", "rotation about P", "rotazione attorno a P"},
    FixedWords{"freedoms prismatic", "translation along X", "traslazione lungo X"},
    FixedWords{"freedoms pin-slot", "rotation about P, translation along X",
               "rotazione attorno a P, traslazione lungo X"},
    FixedWords{"freedoms rolling", "rotation about the contact P", "rotazione attorno al contatto P"},
    FixedWords{"freedoms contact", "rotation about P, sliding along the common tangent",
               "rotazione attorno a P, strisciamento lungo la tangente comune"},
    FixedWords{"freedoms gear", "rotation about P, sliding along the common normal of the pitch curves",
               "rotazione attorno a P, scorrimento lungo la normale comune alle primitive"},
    FixedWords{"class", "class", "classe"},
    FixedWords{"no pair", "none: the two are one body", "nessuna: i due sono un solo corpo"},
    FixedWords{"reaction", "reaction", "reazione"},
    FixedWords{"unknown", "unknown", "incognita"},
    FixedWords{"unknowns", "unknowns", "incognite"},
    FixedWords{"reaction revolute", "force through P in any direction", "forza per P in direzione qualsiasi"},
    FixedWords{"reaction prismatic", "force normal to the guide and a couple", "forza normale alla guida e una coppia"},
    FixedWords{"reaction pin-slot", "force normal to the guide", "forza normale alla guida"},
    FixedWords{"reaction rolling", "force through P in any direction", "forza per P in direzione qualsiasi"},
    FixedWords{"reaction contact", "force through P along the common normal", "forza per P secondo la normale comune"},
    FixedWords{"reaction gear", "force through P along the line of action of the teeth",
               "forza per P secondo la retta d’azione dei denti"},
    FixedWords{"reaction weld", "force through P in any direction and a couple",
               "forza per P in direzione qualsiasi e una coppia"},
    FixedWords{"fixed", "fixed", "elementi fissi"},
    FixedWords{"fixed revolute", "P is one point of both bodies", "P è lo stesso punto dei due corpi"},
    FixedWords{"fixed prismatic", "the line of the guide, the same in both bodies",
               "la retta della guida, la stessa nei due corpi"},
    FixedWords{"fixed pin-slot", "P on body i, the guide on body j", "P sul corpo i, la guida sul corpo j"},
    FixedWords{"fixed rolling", "the profiles; the points at the contact have one velocity",
               "i profili; i punti a contatto hanno la stessa velocità"},
    FixedWords{"fixed contact", "the profiles; the points at the contact have one velocity along the normal",
               "i profili; i punti a contatto hanno la stessa velocità lungo la normale"},
    FixedWords{"fixed gear", "the pitch curves; the points at the pitch point have one velocity along the tangent",
               "le primitive; i punti nel punto primitivo hanno la stessa velocità lungo la tangente"},
    FixedWords{"fixed weld", "every point is one point of both bodies", "ogni punto è lo stesso per i due corpi"},
    FixedWords{"instant centre", "instant centre", "centro di istantanea rotazione"},
    FixedWords{"centre revolute", "P", "P"},
    FixedWords{"centre prismatic", "at infinity, normal to the guide", "all’infinito, in direzione normale alla guida"},
    FixedWords{"centre pin-slot", "on the normal to the guide at P", "sulla normale alla guida in P"},
    FixedWords{"centre rolling", "the contact P", "il contatto P"},
    FixedWords{"centre contact", "on the common normal at P", "sulla normale comune in P"},
    FixedWords{"centre gear", "the pitch point P, where the arm holds both centres",
               "il punto primitivo P, se il portatreno regge i due centri"},
    FixedWords{"centre weld", "everywhere", "ovunque"},
    FixedWords{"pair", "pair", "coppia"},
    FixedWords{"motions", "motions", "moti"},
    FixedWords{"components", "components", "componenti"},
    FixedWords{"space revolute", "revolute", "rotoidale"},
    FixedWords{"space prismatic", "prismatic", "prismatica"},
    FixedWords{"space helical", "helical (screw)", "elicoidale (vite)"},
    FixedWords{"space cylindrical", "cylindrical", "cilindrica"},
    FixedWords{"space planar", "planar", "piana"},
    FixedWords{"space spherical", "spherical", "sferica"},
    FixedWords{"axes of pairs",
               "t translations and r rotations left, F forces and M couples of the reaction; z is the pair’s axis, or "
               "the normal of the planar pair; p is the advance of the screw for each radian.",
               "t traslazioni e r rotazioni residue, F forze e M coppie della reazione; z è l’asse della coppia, o la "
               "normale della coppia piana; p è l’avanzamento della vite per radiante."},
    FixedWords{"multiplicity rule",
               "A hinge of n bodies has multiplicity n − 1: it counts as n − 1 binary hinges of class 1.",
               "Una cerniera di n corpi ha molteplicità n − 1: vale n − 1 cerniere binarie di classe 1."},
    FixedWords{"stars rule", "With all binary hinges on one body there are n equivalent schemes, one for each body.",
               "Con tutte le cerniere binarie su un solo corpo vi sono n schemi equivalenti, uno per ciascun corpo."},
    FixedWords{
        "trees rule",
        "In all there are n^(n − 2), as many as trees on n bodies (Cayley); for n = 3 the two numbers are the same.",
        "In tutto sono n^(n − 2), quanti gli alberi su n corpi (Cayley); per n = 3 i due numeri coincidono."},
    FixedWords{"schemes of three", "A hinge of bodies 1, 2, 3", "Una cerniera dei corpi 1, 2, 3"},
    FixedWords{"bodies at the hinge", "bodies", "corpi"},
    FixedWords{"multiplicity", "multiplicity", "molteplicità"},
    FixedWords{"stars", "all on one body", "tutte su un corpo"},
    FixedWords{"schemes", "in all", "in tutto"},
    FixedWords{"equivalent schemes", "equivalent binary schemes", "schemi binari equivalenti"},
    FixedWords{"pairs", "Pairs", "Coppie"},
    FixedWords{"kind of pair", "pair", "tipo"},
    FixedWords{"bodies of a pair", "bodies", "corpi"},
    FixedWords{"count", "Count of the freedoms (Grübler)", "Computo dei gradi di libertà (Grübler)"},
    FixedWords{"symbols of the first count",
               "m bodies with the frame, c₁ pairs of class 1, c₂ of class 2, w clamped joints; multiple hinges count "
               "by their multiplicity.",
               "m corpi compreso il telaio, c₁ coppie di classe 1, c₂ di classe 2, w incastri; le cerniere multiple "
               "contano secondo la molteplicità."},
    FixedWords{"symbols of the second count",
               "n_c bodies without the frame, n₁ single, n₂ double and n₃ triple constraints.",
               "n_c corpi escluso il telaio, n₁ vincoli semplici, n₂ doppi e n₃ tripli."},
    FixedWords{"at this position", "At this position (instantaneous)", "In questa configurazione (istantaneo)"},
    FixedWords{"rank", "rank", "rango"},
    FixedWords{"constraints", "constraints", "vincoli"},
    FixedWords{"repeated", "repeated", "ripetuti"},
    FixedWords{"conventions", "Conventions", "Convenzioni"},
    FixedWords{"axes", "z points towards the reader; ω and α are positive counter-clockwise.",
               "Asse z verso chi legge; ω e α positive in senso antiorario."},
    FixedWords{"axes forces", "z points towards the reader; couples are positive counter-clockwise.",
               "Asse z verso chi legge; momenti positivi in senso antiorario."},
    FixedWords{"measured", "lengths measured to 0.1 mm, drawing = mm × scale",
               "lunghezze misurate a 0,1 mm, disegno = mm × scala"},
    // the table of knowns
    FixedWords{"magnitude", "magnitude", "modulo"},
    FixedWords{"direction", "direction", "direzione"},
    FixedWords{"line", "line", "retta"},
    // results
    FixedWords{"drawing", "drawing", "disegno"},
    FixedWords{"numeric", "numeric", "numerico"},
    FixedWords{"unit", "unit", "unità"},
    FixedWords{"difference", "diff.", "diff."},
    FixedWords{"centre", "centre", "centro"},
    FixedWords{"found by", "found by", "costruzione"},
    FixedWords{"everywhere", "everywhere", "ogni punto"},
    FixedWords{"at infinity", "at infinity", "all’infinito"},
    FixedWords{"not found", "not found", "non trovato"},
    FixedWords{"found revolute", "hinge", "cerniera"},
    FixedWords{"found prismatic", "normal to the guide at", "normale alla guida in"},
    FixedWords{"found pin-slot", "normal at", "normale in"},
    FixedWords{"found rolling", "contact", "contatto"},
    FixedWords{"found contact", "normal at", "normale in"},
    FixedWords{"found gear", "pitch point", "punto primitivo"},
    FixedWords{"found weld", "clamped at", "incastro in"},
    FixedWords{"normal at", "normal at", "normale in"},
    FixedWords{"and", "and", "e"},
    FixedWords{"found by rest", "no relative motion", "nessun moto relativo"},
    FixedWords{"from velocities", "from the velocities", "dalle velocità"},
    FixedWords{"depends on drivers", "for this ratio of the drivers", "per questo rapporto dei moventi"},
    FixedWords{"point", "point", "punto"},
    FixedWords{"velocity", "velocity", "velocità"},
    FixedWords{"acceleration", "acceleration", "accelerazione"},
    FixedWords{"sliding", "Sliding", "Scorrimenti"},
    FixedWords{"at", "at", "in"},
    FixedWords{"on", "on", "su"},
    FixedWords{"modulus", "modulus", "modulo"},
    FixedWords{"coriolis", "Coriolis", "Coriolis"},
    FixedWords{"turned with", " turned 90° with ", " ruotata di 90° nel verso di "},
    FixedWords{"largest difference", "Largest difference between construction and check",
               "Massima differenza fra costruzione e verifica"},
    FixedWords{"relative to velocity", "of the largest", "del massimo"},
    FixedWords{"nothing driven", "Nothing is driven: the drawing shows the position and its centres.",
               "Nessun movente: il disegno mostra la configurazione e i centri."},
    // trusses
    FixedWords{"truss", "Truss: bars and spaces", "Travatura: aste e spazi"},
    FixedWords{"cremona", "Cremona diagram", "Diagramma di Cremona"},
    FixedWords{"bars", "Bars", "Aste"},
    FixedWords{"bar", "bar", "asta"},
    FixedWords{"spaces", "spaces", "spazi"},
    FixedWords{"axial force", "force", "sforzo"},
    FixedWords{"sense", "sense", "verso"},
    FixedWords{"tension", "tension", "trazione"},
    FixedWords{"compression", "compression", "compressione"},
    FixedWords{"idle", "no force", "scarica"},
    FixedWords{"idle by rule", "no force (by rule)", "scarica (a vista)"},
    // of bodies, for the key: a coincident point, and the kinds of bodies
    FixedWords{"coincident point", "{0}\u00A0at\u00A0{1}", "{0}\u00A0in\u00A0{1}"},
    FixedWords{"crank", "crank", "manovella"},
    FixedWords{"rocker", "rocker", "bilanciere"},
    FixedWords{"coupler", "coupler", "biella"},
    FixedWords{"slider", "slider", "cursore"},
    FixedWords{"sleeve", "sleeve", "manicotto"},
    FixedWords{"cylinder", "cylinder", "cilindro"},
    FixedWords{"rod", "rod", "stelo"},
    FixedWords{"slotted link", "slotted link", "glifo"},
    FixedWords{"link", "link", "asta"},
    FixedWords{"disc", "disc", "disco"},
    // title block
    FixedWords{"block scale", "Scale", "Scala"},
    FixedWords{"block scales", "Scales", "Scale"},
    FixedWords{"block size", "Size", "Formato"},
    FixedWords{"block sheet", "Sheet", "Foglio"},
    FixedWords{"block units", "Units", "Unità"},
    FixedWords{"block readings", "Readings to", "Letture a"},
    FixedWords{"block file", "File", "File"},
    FixedWords{"block bodies", "Bodies", "Corpi"},
    FixedWords{"block points", "Points", "Punti"},
    FixedWords{"untitled", "Mechanism", "Meccanismo"},
    // forces
    FixedWords{"mechanism and lines of action", "Mechanism and lines of action", "Meccanismo e rette d’azione"},
    FixedWords{"force triangle", "Force triangle", "Triangolo delle forze"},
    FixedWords{"force triangles", "Force triangles", "Triangoli delle forze"},
    FixedWords{"force polygon", "Force polygon", "Poligono delle forze"},
    FixedWords{"force polygons", "Force polygons", "Poligoni delle forze"},
    FixedWords{"closed force polygon", "Closed polygon of the external forces", "Poligono chiuso delle forze esterne"},
    FixedWords{"truss whole", "the whole truss", "l’intera travatura"},
    FixedWords{"bodies together", "bodies", "corpi"},
    FixedWords{"loads alone", "Loads alone on", "Carichi del solo"},
    FixedWords{"loads of body", "body", "corpo"},
    FixedWords{"loads of pin", "pin", "nodo"},
    FixedWords{"sums of partial forces", "Sums of the partial forces", "Somme delle forze parziali"},
    FixedWords{"funicular polygon", "Funicular polygon", "Poligono funicolare"},
    FixedWords{"free body", "Free body", "Corpo libero"},
    FixedWords{"free pin", "Free pin", "Perno isolato"},
    FixedWords{"pin", "pin", "perno"},
    FixedWords{"forces", "Active forces and reactions", "Forze attive e reazioni"},
    FixedWords{"active forces", "active", "attive"},
    FixedWords{"reactions", "reactions", "reazioni"},
    FixedWords{"reactions heading", "Reactions", "Reazioni"},
    FixedWords{"efforts", "Efforts", "Azioni equilibranti"},
    FixedWords{"force", "force", "forza"},
    FixedWords{"joint", "joint", "coppia"},
    FixedWords{"couple", "couple", "momento"},
    FixedWords{"effort", "effort", "azione"},
    FixedWords{"resultant of what is given", "Resultant of what is given (M about the origin)",
               "Risultante di ciò che è assegnato (M rispetto all’origine)"},
    FixedWords{"in equilibrium", "in equilibrium", "in equilibrio"},
    FixedWords{"not in equilibrium", "not in equilibrium", "non in equilibrio"},
    FixedWords{"steps forces", "Steps: forces", "Procedimento: forze"},
    FixedWords{"vertical", "vertical", "verticale"},
    // questions and keys
    FixedWords{"likewise", "Likewise", "Allo stesso modo"},
    FixedWords{"answers", "Answers", "Risposte"},
    FixedWords{"value", "value", "valore"},
    FixedWords{"subtitle question", "Exercise", "Esercizio"},
    FixedWords{"subtitle answers", "Key: answers only", "Soluzioni: solo i risultati"},
    FixedWords{"subtitle parameter", "The results over a parameter", "I risultati al variare di un parametro"},
    FixedWords{"subtitle cycle", "The motion through a cycle", "Il moto lungo un ciclo"},
    FixedWords{"tolerances",
               "Vectors are read to 0.5 mm at the scale of the drawing, angular velocities and accelerations found "
               "from a vector and a length, couples from a force and its arm.",
               "I vettori si leggono a 0,5 mm nella scala del disegno; velocità e accelerazioni angolari si ricavano "
               "da un vettore e una lunghezza, i momenti da una forza e dal suo braccio."},
    FixedWords{"mechanism and its data", "The mechanism with its data", "Il meccanismo con i suoi dati"},
    FixedWords{"data", "Data", "Dati"},
    FixedWords{"sought", "Sought", "Si chiede"},
    FixedWords{"scales", "Scales", "Scale"},
    FixedWords{"cam turns counter-clockwise", "the cam turns counter-clockwise,",
               "la camma ruota in senso antiorario,"},
    FixedWords{"cam turns clockwise", "the cam turns clockwise,", "la camma ruota in senso orario,"},
    FixedWords{"translating roller", "translating roller follower", "punteria traslante a rotella"},
    FixedWords{"oscillating roller", "oscillating roller follower", "punteria oscillante a rotella"},
    FixedWords{"translating flat", "translating flat-faced follower", "punteria traslante a piattello"},
    FixedWords{"oscillating flat", "oscillating flat-faced follower", "punteria oscillante a piattello"},
    FixedWords{"translating edge", "translating knife-edge follower", "punteria traslante a coltello"},
    FixedWords{"oscillating edge", "oscillating knife-edge follower", "punteria oscillante a coltello"},
    FixedWords{"offset", "offset", "eccentricità"},
    FixedWords{"pivot", "pivot", "perno"},
    FixedWords{"arm", "arm", "braccio"},
    FixedWords{"rise is counter-clockwise", "β: rise, positive away from the cam, here counter-clockwise:",
               "β: alzata, positiva se allontana dalla camma, qui in senso antiorario:"},
    FixedWords{"rise is clockwise", "β: rise, positive away from the cam, here clockwise:",
               "β: alzata, positiva se allontana dalla camma, qui in senso orario:"},
    FixedWords{"law rise", "rise of", "alzata di"},
    FixedWords{"law return", "return of", "ritorno di"},
    FixedWords{"law rest", "dwell", "sosta"},
    FixedWords{"law constant speed", "constant speed", "velocità costante"},
    FixedWords{"law constant acceleration", "constant acceleration", "accelerazione costante"},
    FixedWords{"law harmonic", "harmonic", "armonica"},
    FixedWords{"law cycloidal", "cycloidal", "cicloidale"},
    FixedWords{"law 3-4-5", "polynomial 3-4-5", "polinomiale 3-4-5"},
    FixedWords{"law modified trapezoidal", "modified trapezoidal", "trapezia modificata"},
    FixedWords{"data coordinates", "Coordinates [{0}]: {1}.", "Coordinate [{0}]: {1}."},
    FixedWords{"data polar", "{0}{1} = {2}, at {3} to the axis x.", "{0}{1} = {2}, a {3} dall’asse x."},
    FixedWords{"data polar relative", "{0}{1} = {2}, at {3} to {4}{5}.", "{0}{1} = {2}, a {3} da {4}{5}."},
    FixedWords{"data along", "{1} on the line {0}{2}: {0}{1} = {3}.", "{1} sulla retta {0}{2}: {0}{1} = {3}."},
    FixedWords{"data ratio", "{1} on the line {0}{2}: {0}{1} = {3} {0}{2}.",
               "{1} sulla retta {0}{2}: {0}{1} = {3} {0}{2}."},
    FixedWords{"data meet", "{0}: {1} and {2}{3}.", "{0}: {1} e {2}{3}."},
    FixedWords{"data nearer", ", the one nearer to {0}", ", dei due punti quello più vicino a {0}"},
    FixedWords{"data on the left", ", on the left of the way from {0} to {1}", ", a sinistra andando da {0} a {1}"},
    FixedWords{"data on the right", ", on the right of the way from {0} to {1}", ", a destra andando da {0} a {1}"},
    FixedWords{"data ahead", ", of the two the one farther on in the sense of the line",
               ", dei due punti quello più avanti nel verso della retta"},
    FixedWords{"data behind", ", of the two the one farther back in the sense of the line",
               ", dei due punti quello più indietro nel verso della retta"},
    FixedWords{"data radius", "{0}{1} = {2}", "{0}{1} = {2}"},
    FixedWords{"data radius of place", "at {2} from {0}", "a {2} da {0}"},
    FixedWords{"data line angle", "on the line through {0} at {1}", "sulla retta per {0} a {1}"},
    FixedWords{"data line to", "on the line {0}{1}", "sulla retta {0}{1}"},
    FixedWords{"data line parallel", "on the line through {0} parallel to {1}", "sulla retta per {0} parallela a {1}"},
    FixedWords{"data line perpendicular", "on the line through {0} normal to {1}", "sulla retta per {0} normale a {1}"},
    FixedWords{"data the direction", "the direction of {0}", "la direzione di {0}"},
    FixedWords{"data wheel", "Body {0}: R = {1} about {2}.", "Corpo {0}: R = {1} con centro {2}."},
    FixedWords{"data hinges", "Hinges: {0}.", "Cerniere: {0}."},
    FixedWords{"data clamps", "Clamped together: {0}.", "Incastri: {0}."},
    FixedWords{"data the frame", "the frame", "il telaio"},
    FixedWords{"data bare body", "body {0}", "corpo {0}"},
    FixedWords{"data the body", "body {0}", "il corpo {0}"},
    FixedWords{"data the bar", "bar {0}", "l’asta {0}"},
    FixedWords{"data of the bar", "of bar {0}", "dell’asta {0}"},
    FixedWords{"data of the frame", "of the frame", "del telaio"},
    FixedWords{"data of the body", "of body {0}", "del corpo {0}"},
    FixedWords{"along a line", "along {0}", "lungo {0}"},
    FixedWords{"along an angle", "along {0}", "in direzione {0}"},
    FixedWords{"data guide", "At {0} {1} slides on a guide {2} {3}.", "In {0} {1} scorre su una guida {2} {3}."},
    FixedWords{"data slot", "At {0} a pin {1} slides in a slot {2} {3}.",
               "In {0} un perno {1} scorre in un glifo {2} {3}."},
    FixedWords{"data curved slot", "At {0} a pin {1} slides in a slot {2} that is curved about {3}.",
               "In {0} un perno {1} scorre in un glifo {2} curvo con centro {3}."},
    FixedWords{"data support", "At {0} {1} rests on the frame by a roller that runs {2}.",
               "In {0} {1} poggia sul telaio con un carrello che scorre {2}."},
    FixedWords{"data slides", "At {0} {1} and {2} touch and slide on each other: {3}.",
               "In {0} {1} e {2} si toccano e strisciano l’uno sull’altro: {3}."},
    FixedWords{"data rolls", "At {0} {1} and {2} roll on each other without slip: {3}.",
               "In {0} {1} e {2} rotolano l’uno sull’altro senza strisciare: {3}."},
    FixedWords{"data meshes", "At {0} {1} and {2} mesh: {3}.", "In {0} {1} e {2} ingranano: {3}."},
    FixedWords{"data tangent", "tangent along {0}", "tangente lungo {0}"},
    FixedWords{"data straight", "{0} is straight along {1}", "{0} è rettilineo lungo {1}"},
    FixedWords{"data round", "{0} is round about {1}", "{0} è circolare con centro {1}"},
    FixedWords{"data tip", "{0} has a tip", "{0} ha uno spigolo"},
    FixedWords{"data arm", "{0} is the arm", "{0} è il portatreno"},
    FixedWords{"data pushes", "The contact at {0} can only push {1}, along {2}.",
               "Il contatto in {0} può solo spingere {1}, lungo {2}."},
    FixedWords{"data pressure angle", "Pressure angle at {0}: {1}.", "Angolo di pressione in {0}: {1}."},
    FixedWords{"data spin", "Body {0} is driven: {1}, {2}.", "Corpo {0} comandato: {1}, {2}."},
    FixedWords{"data spin relative", "Body {0} is driven relative to body {3}: {1}, {2}.",
               "Corpo {0} comandato rispetto al corpo {3}: {1}, {2}."},
    FixedWords{"data slide", "At {0} {1} is driven along its guide {2}: {3}, {4}, {5}.",
               "In {0} {1} è comandato lungo la guida {2}: {3}, {4}; velocità {5}."},
    FixedWords{"data driven point", "{0} (body {4}) is driven along {3}: components {1}, {2} in that sense.",
               "{0} (corpo {4}) è comandato lungo {3}: componenti {1}, {2} in quel verso."},
    FixedWords{"data mass", "Body {0}: mass {1}, centre {2}, J = {3}.",
               "Corpo {0}: massa {1}, baricentro {2}, J = {3}."},
    FixedWords{"data gravity", "Gravity: {0}.", "Gravità: {0}."},
    FixedWords{"data inertia", "Inertia forces are to be taken into account.", "Si tenga conto delle forze d’inerzia."},
    FixedWords{"data no inertia", "Inertia forces are neglected.", "Le forze d’inerzia sono trascurate."},
    FixedWords{"data force", "{0} on body {1} at {2}: {3}.", "{0} sul corpo {1} in {2}: {3}."},
    FixedWords{"data force along", "{0} on body {1} at {2}: {3} along {4}.",
               "{0} sul corpo {1} in {2}: {3} lungo {4}."},
    FixedWords{"data force on bar", "{0} on bar {1} at {2}: {3}.", "{0} sull’asta {1} in {2}: {3}."},
    FixedWords{"data force on bar along", "{0} on bar {1} at {2}: {3} along {4}.",
               "{0} sull’asta {1} in {2}: {3} lungo {4}."},
    FixedWords{"data couple", "{0} on body {1}: {2}, counter-clockwise positive.",
               "{0} sul corpo {1}: {2}, positivo se antiorario."},
    FixedWords{"data spring", "{0} pulls {1} ({5}) and {2} ({6}) together: {3}.",
               "{0} tira l’uno verso l’altro {1} ({5}) e {2} ({6}): {3}."},
    FixedWords{"data gas spring", "{0} pushes {1} ({5}) and {2} ({6}) apart: {3}.",
               "{0} allontana l’uno dall’altro {1} ({5}) e {2} ({6}): {3}."},
    FixedWords{"data elastic spring", "Spring {0} between {1} ({5}) and {2} ({6}): stiffness {3}, free length {4}.",
               "Molla {0} fra {1} ({5}) e {2} ({6}): rigidezza {3}, lunghezza a riposo {4}."},
    FixedWords{"data torsion",
               "Torsion spring {0} at {3} between bodies {1} and {2}: stiffness {4}; body {1}, seen from {2}, is "
               "turned by {5}.",
               "Molla di torsione {0} in {3} fra i corpi {1} e {2}: rigidezza {4}; il corpo {1}, visto da {2}, è "
               "ruotato di {5}."},
    FixedWords{"data distributed", "Load {0} on body {1} from {2} to {3}: intensity from {4} to {5} along {6}.",
               "Carico {0} sul corpo {1} da {2} a {3}: intensità da {4} a {5} lungo {6}."},
    FixedWords{"data evenly distributed", "Load {0} on body {1} from {2} to {3}: {4} along {5}.",
               "Carico {0} sul corpo {1} da {2} a {3}: {4} lungo {5}."},
    FixedWords{"data pin load", "{0} on the pin {1}: {2}.", "{0} sul perno {1}: {2}."},
    FixedWords{"data pin load along", "{0} on the pin {1}: {2} along {3}.", "{0} sul perno {1}: {2} lungo {3}."},
    FixedWords{"data given vector", "{0} = {1}.", "{0} = {1}."},
    FixedWords{"data given line", "{0} runs along {1}.", "{0} ha direzione {1}."},
    FixedWords{"sought centres", "the instant centres", "i centri di istantanea rotazione"},
    FixedWords{"sought velocity", "the velocities of the points and the angular velocities of the bodies",
               "le velocità dei punti e le velocità angolari dei corpi"},
    FixedWords{"sought acceleration", "the accelerations of the points and the angular accelerations of the bodies",
               "le accelerazioni dei punti e le accelerazioni angolari dei corpi"},
    FixedWords{"sought curvature", "the inflection circles and the centres of curvature of the paths",
               "i circoli dei flessi e i centri di curvatura delle traiettorie"},
    FixedWords{"sought equations",
               "the closure equations in the letters of figure 2, their Jacobian, velocity ratios and accelerations",
               "le equazioni di chiusura con le lettere della figura 2, lo jacobiano, i rapporti di velocità e le "
               "accelerazioni"},
    FixedWords{"sought work",
               "by virtual work, without reactions:", "con il principio dei lavori virtuali, senza le reazioni:"},
    FixedWords{"sought through", "the motion, found from {0} as an observer on body {1} sees it",
               "il moto, ricavato dal moto relativo di {0} per un osservatore solidale al corpo {1}"},
    FixedWords{"sought relative", "the motion of {0} as seen from body {1}", "il moto di {0} rispetto al corpo {1}"},
    FixedWords{"sought translating", "the motion of {0} as seen from axes that translate with {1}",
               "il moto di {0} rispetto ad assi traslanti con {1}"},
    FixedWords{"sought bars", "the forces in the bars, tension or compression",
               "gli sforzi nelle aste, trazione o compressione"},
    FixedWords{"sought cut", "again by a cut through {0}", "gli stessi con una sezione di {0}"},
    FixedWords{"sought forces", "the reactions at the joints", "le reazioni nelle coppie"},
    FixedWords{"sought couple", "the couple {0} on body {1} that balances",
               "il momento equilibrante {0} sul corpo {1}"},
    FixedWords{"sought couple between", "the couple {0} on body {1}, from body {2}, that balances",
               "il momento equilibrante {0} sul corpo {1}, dal corpo {2}"},
    FixedWords{"sought force", "the force {0} on body {1} at {2} that balances, {3}",
               "la forza equilibrante {0} sul corpo {1} in {2}, {3}"},
    FixedWords{"sought actuator", "the force {0} of the actuator at {1} that balances, {2} {3}, {4}",
               "la forza equilibrante {0} dell’attuatore in {1}, {2} {3}, {4}"},
    FixedWords{"on the frame", "on the frame", "sul telaio"},
    FixedWords{"on the body", "on body {0}", "sul corpo {0}"},
    FixedWords{"from the frame", "from the frame", "dal telaio"},
    FixedWords{"from the body", "from body {0}", "dal corpo {0}"},
    FixedWords{"sense of couple between", "{0} acts {1} {2}, counter-clockwise positive.",
               "{0} agisce {1} {2}, positivo se antiorario."},
    FixedWords{"sense of effort", "{0} acts {1} and is {2}; its direction is that sense.",
               "{0} agisce {1} ed è {2}; la direzione è quella di questo verso."},
    FixedWords{"sought forces scale", "Forces", "Forze"},
    FixedWords{"scale of detail", "detail for", "particolare per"},
    FixedWords{"reading says nothing",
               "At this scale a reading says nothing of {0}: it may be off by as much as the value, so that zero and "
               "the wrong sign pass.",
               "A questa scala una lettura non dice nulla di {0}: l’errore può essere pari al valore, e passano anche "
               "zero e il segno opposto."},
    FixedWords{"asked angle", "the direction {0} of body {1}, from the axis x",
               "l’inclinazione {0} del corpo {1} sull’asse x"},
    FixedWords{"asked angle of line", "the direction {0} of body {1}: of {2}{3}, from {2} to {3}, from the axis x",
               "l’inclinazione {0} del corpo {1} sull’asse x: di {2}{3}, da {2} verso {3}"},
    FixedWords{"asked omega", "the angular velocity {0} of body {1}", "la velocità angolare {0} del corpo {1}"},
    FixedWords{"asked alpha", "the angular acceleration {0} of body {1}", "l’accelerazione angolare {0} del corpo {1}"},
    FixedWords{"asked place", "the coordinate {0} of {1}", "la coordinata {0} di {1}"},
    FixedWords{"asked point of body", "{0} (as of body {1})", "{0} (del corpo {1})"},
    FixedWords{"asked velocity", "the velocity {0} of {1}", "la velocità {0} di {1}"},
    FixedWords{"asked part of velocity", "the component {0} of the velocity of {1}",
               "la componente {0} della velocità di {1}"},
    FixedWords{"asked acceleration", "the acceleration {0} of {1}", "l’accelerazione {0} di {1}"},
    FixedWords{"asked part of acceleration", "the component {0} of the acceleration of {1}",
               "la componente {0} dell’accelerazione di {1}"},
    FixedWords{"asked sliding velocity", "the sliding velocity {0} {1} {2} at {3}, {4}",
               "la velocità di scorrimento {0} {1} {2} in {3}, {4}"},
    FixedWords{"asked sliding acceleration", "the sliding acceleration {0} {1} {2} at {3}, {4}",
               "l’accelerazione di scorrimento {0} {1} {2} in {3}, {4}"},
    FixedWords{"sense of sliding", "{0} {1} {2} at {3} is {4}; its direction is that sense.",
               "{0} {1} {2} in {3} è {4}; la direzione è quella di questo verso."},
    FixedWords{"relative to the frame", "relative to the frame", "rispetto al telaio"},
    FixedWords{"relative to the body", "relative to body {0}", "rispetto al corpo {0}"},
    FixedWords{"positive from", "positive from {0} to {1}", "positiva da {0} verso {1}"},
    FixedWords{"positive along", "positive along {0}", "positiva lungo {0}"},
    FixedWords{"asked bar", "the force {0} in the bar {1}, tension positive",
               "lo sforzo {0} nell’asta {1}, positivo di trazione"},
    FixedWords{"asked numbered bar", "the force {0} in the bar {1} (body {2}), tension positive",
               "lo sforzo {0} nell’asta {1} (corpo {2}), positivo di trazione"},
    FixedWords{"sense of bars", "Forces in bars: tension is positive, compression negative.",
               "Sforzi nelle aste: positivi di trazione, negativi di compressione."},
    FixedWords{"asked force", "the force {0} of body {1} on body {2} at {3}",
               "la forza {0} del corpo {1} sul corpo {2} in {3}"},
    FixedWords{"asked part of force", "the component {0} of the force of body {1} on body {2} at {3}",
               "la componente {0} della forza del corpo {1} sul corpo {2} in {3}"},
    FixedWords{"asked force of pin", "the force {0} of the pin {3} on body {2}",
               "la forza {0} del perno {3} sul corpo {2}"},
    FixedWords{"asked part of force of pin", "the component {0} of the force of the pin {3} on body {2}",
               "la componente {0} della forza del perno {3} sul corpo {2}"},
    FixedWords{"asked couple", "the couple {0} of body {1} on body {2} at {3}",
               "il momento {0} del corpo {1} sul corpo {2} in {3}"},
    FixedWords{"asked couple of pin", "the couple {0} of the pin {3} on body {2}",
               "il momento {0} del perno {3} sul corpo {2}"},
    FixedWords{"asked transmission", "the least transmission angle {0}", "il minimo angolo di trasmissione {0}"},
    FixedWords{"asked transmission at",
               "the least transmission angle {0} of the whole travel, that at {1} (body {2} on body {3})",
               "il minimo angolo di trasmissione {0} di tutta la corsa, quello in {1} (corpo {2} sul corpo {3})"},
    FixedWords{"asked by name", "{1}", "{1}"},
    FixedWords{"quiz signs",
               "Angular velocities and accelerations, couples and angles count counter-clockwise positive.",
               "Velocità e accelerazioni angolari, momenti e angoli sono positivi in senso antiorario."},
    FixedWords{"quiz lengths",
               "Of vectors the magnitude is asked for, unless a component or a positive sense is named.",
               "Dei vettori si chiede il modulo, se non è indicata una componente o un verso positivo."},
    FixedWords{"given", "given", "data"},
    FixedWords{"normal", "normal", "normale"},
    FixedWords{"line of the teeth", "of action", "d’azione"},
    FixedWords{"any line", "–", "–"},
    FixedWords{"action and reaction", "acts from body {0} on body {1}.", "è l’azione del corpo {0} sul corpo {1}."},
    FixedWords{"internal sides", "Dashed sides are internal: equal and opposite on two bodies, they cancel.",
               "I lati tratteggiati sono interni: uguali e opposti su due corpi, si elidono."},
    FixedWords{"passes outside", "passes outside: it tilts", "passa fuori: si impunta"},
    FixedWords{"passes beside", "from", "da"},
    FixedWords{"lever", "Joukowsky’s lever", "Leva di Joukowsky"},
    FixedWords{"lever arm", "arm", "braccio"},
    FixedWords{"power", "power", "potenza"},
    FixedWords{"sum", "sum", "somma"},
    FixedWords{"lever of forces",
               "The forces, set at the tips of the velocities turned a quarter turn counter-clockwise, have no moment "
               "about the "
               "pole: the moment of each, F·h, is its power with the sign changed.",
               "Le forze, poste agli estremi delle velocità ruotate di un quarto di giro in verso antiorario, hanno "
               "momento nullo "
               "rispetto al polo: il momento di ciascuna, F·h, è la sua potenza cambiata di segno."},
    FixedWords{
        "lever with couples",
        "The forces are set at the tips of the velocities turned a quarter turn counter-clockwise: the moment of each "
        "about the pole, F·h, is its power with the sign changed; a couple has the power Mω. The powers add up to "
        "nothing.",
        "Le forze sono poste agli estremi delle velocità ruotate di un quarto di giro in verso antiorario: il momento "
        "di "
        "ciascuna rispetto al polo, F·h, è la sua potenza cambiata di segno; una coppia ha potenza Mω. La somma delle "
        "potenze è nulla."},
    FixedWords{"subtitle forces", "Forces by free bodies and force polygons",
               "Forze con i corpi liberi e i poligoni delle forze"},
    FixedWords{"subtitle truss", "Forces in the bars by Cremona’s diagram and by cuts",
               "Sforzi nelle aste con il diagramma di Cremona e con sezioni"},
    FixedWords{"subtitle mixed", "Motion and forces by polygons", "Moto e forze con i poligoni"},
    FixedWords{"subtitle pose", "Position and instant centres", "Configurazione e centri di istantanea rotazione"},
    FixedWords{"subtitle velocity", "Instant centres and velocities", "Centri di istantanea rotazione e velocità"},
    FixedWords{"subtitle cam", "A disc cam by the law of its follower", "Camma a disco dalla legge della punteria"},
    FixedWords{"subtitle acceleration", "Velocities and accelerations by polygons",
               "Velocità e accelerazioni con i poligoni"},
});

bool digits_only(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || c == ',' || c == '.'; });
}

Piece piece(std::string_view text, Face face = Face::regular) {
    Piece result;
    result.text = text;
    result.face = face;
    return result;
}

/// A point's name as in textbooks: italic, with the number of O2 as a subscript.
RichText point_name(std::string_view name) {
    std::size_t digits = name.size();
    std::string_view tail;
    while (digits > 0 && (name[digits - 1] == '*' || name[digits - 1] == '\'')) --digits;
    tail = name.substr(digits);
    std::size_t letters = digits;
    while (letters > 0 && name[letters - 1] >= '0' && name[letters - 1] <= '9') --letters;
    std::string primes, raised_stars;
    for (const char c : tail) (c == '*' ? raised_stars : primes) += c == '*' ? "∗" : "′";
    const bool lowers = letters > 0 && letters < digits && name[letters - 1] != '.' && name[letters - 1] != '-';
    Piece result = piece(name.substr(0, lowers ? letters : digits), digits_only(name) ? Face::regular : Face::italic);
    result.text += primes;
    if (lowers) result.sub = name.substr(letters, digits - letters);
    result.sub_face = Face::regular;
    if (lowers)
        result.sup = raised_stars;
    else
        result.text += std::string(static_cast<std::size_t>(std::count(tail.begin(), tail.end(), '*')), '*');
    return {result};
}

std::string lower_case(std::string_view name) {
    std::string out;
    for (const char c : name) out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return out;
}

/// A no-break space.
constexpr const char* unbroken_blank = "\u00A0";

/// "lbf in", without a line break.
std::string unbroken(std::string unit) {
    for (std::size_t at = unit.find(' '); at != std::string::npos; at = unit.find(' ', at))
        unit.replace(at, 1, unbroken_blank);
    return unit;
}

/// Symbols as in the figures, or names as spelt in files and commands.
enum class Setting { typeset, spelt };

/// Typesets an argument of a sentence, by an overload per type.
class ArgumentSetter {
public:
    ArgumentSetter(Language language, Setting setting) : language_(language), setting_(setting) {}

    RichText operator()(const PointName& value) const { return name(value.name); }
    RichText operator()(const BodyName& value) const {
        return value.as == BodyName::As::pin ? name(value.name) : RichText{piece(value.name)};
    }
    RichText operator()(const JointName& value) const {
        return value.own ? RichText{piece(value.name)} : name(value.name);
    }
    RichText operator()(const Count& value) const {
        return {piece((value.value < 0 ? "−" : "") + std::to_string(std::abs(value.value)))};
    }
    RichText operator()(const Symbol& value) const {
        return setting_ == Setting::spelt ? RichText{piece(name_of(value))} : typeset(value, language_);
    }
    RichText operator()(const Names& value) const {
        return in_a_row(value, [&](const std::string& each) { return name(each); });
    }
    RichText operator()(const Symbols& value) const { return in_a_row(value, *this); }
    RichText operator()(const Ratios& value) const { return in_a_row(value, *this); }
    RichText operator()(const Ratio& value) const {
        constexpr int digits = 5;
        RichText text = (*this)(value.above);
        text.push_back(piece("/"));
        append(text, (*this)(value.below));
        text.push_back(piece(" = " + number(value.value, digits, language_)));
        return text;
    }
    RichText operator()(const kinegraph::Segment& value) const {
        RichText text = name(value.from);
        append_point(text, name(value.to));
        return text;
    }
    RichText operator()(const std::string& value) const { return {piece(value)}; }
    RichText operator()(const Amount& value) const {
        return {piece(number(value.value, 3, language_) + blank() +
                      (setting_ == Setting::typeset ? unbroken(value.unit) : value.unit))};
    }
    RichText operator()(const RollingLever& value) const {
        if (value == RollingLever::on_straight) return {piece("r", Face::italic)};
        return {piece("R" + blank() + "r", Face::italic),
                piece("/("),
                piece("R", Face::italic),
                piece(blank() + (value == RollingLever::outside ? "+" : "−") + blank()),
                piece("r", Face::italic),
                piece(")")};
    }
    RichText operator()(const LineReason& value) const {
        RichText text = typeset(value, language_);
        if (!text.empty() && text.front().text.ends_with(' '))
            text.front().text.replace(text.front().text.size() - 1, 1, blank());
        return text;
    }

private:
    std::string blank() const { return setting_ == Setting::typeset ? unbroken_blank : " "; }
    RichText name(const std::string& of) const {
        return setting_ == Setting::spelt ? RichText{piece(of)} : point_name(of);
    }
    template <class Members, class Set>
    static RichText in_a_row(const Members& members, const Set& set) {
        RichText text;
        for (const auto& member : members) {
            if (!text.empty()) text.push_back(piece(", "));
            append(text, set(member));
        }
        return text;
    }

    Language language_;
    Setting setting_;
};

RichText argument(const Argument& arg, Language language, Setting setting) {
    return std::visit(ArgumentSetter(language, setting), arg);
}

/// Sorted first: comparing all pairs exceeds the constexpr limits of some compilers.
constexpr bool keys_are_different() {
    std::array<std::string_view, fixed_words.size()> keys{};
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = fixed_words[i].key;
    std::sort(keys.begin(), keys.end());
    return std::adjacent_find(keys.begin(), keys.end()) == keys.end();
}
static_assert(keys_are_different(), "a key has one row of words");

constexpr bool rows_are_in_order() {
    for (std::size_t i = 0; i < sentences.size(); ++i)
        if (sentences[i].sentence != static_cast<Sentence>(i) || sentences[i].en.empty() || sentences[i].it.empty())
            return false;
    return sentences.size() == static_cast<std::size_t>(Sentence::count_);
}
static_assert(rows_are_in_order(), "every sentence has its words, in the order of the enumeration");

std::string_view pattern_of(Sentence sentence, Language language) {
    KG_ASSERT(sentence < Sentence::count_, "a message has a sentence");
    const Row& row = sentences[static_cast<std::size_t>(sentence)];
    return language == Language::en ? row.en : row.it;
}

/// Replaces every first word of a pair by the second.
template <class Pairs>
std::string replaced(std::string pattern, const Pairs& pairs) {
    for (const auto& [said, instead] : pairs)
        for (std::size_t at = pattern.find(said); at != std::string::npos; at = pattern.find(said, at + instead.size()))
            pattern.replace(at, said.size(), instead);
    return pattern;
}
/// Adapts a pattern about a body to a truss that is cut free as a whole.
std::string of_truss(std::string pattern, Language language) {
    static constexpr std::array<std::array<std::string_view, 2>, 2> english{
        {{"Body {0}", "The truss"}, {"body {0}", "the truss"}}};
    static constexpr std::array<std::array<std::string_view, 2>, 5> italian{{{"Sul corpo {0}", "Sulla travatura"},
                                                                             {"sul corpo {0}", "sulla travatura"},
                                                                             {"del corpo {0}", "della travatura"},
                                                                             {"Il corpo {0}", "La travatura"},
                                                                             {"il corpo {0}", "la travatura"}}};
    return language == Language::en ? replaced(std::move(pattern), english) : replaced(std::move(pattern), italian);
}
/// Adapts it to the pin of a hinge.
std::string of_pin(std::string pattern, Language language) {
    static constexpr std::array<std::array<std::string_view, 2>, 2> english{
        {{"Body {0}", "Pin {0}"}, {"body {0}", "pin {0}"}}};
    static constexpr std::array<std::array<std::string_view, 2>, 1> italian{{{"corpo {0}", "perno {0}"}}};
    return language == Language::en ? replaced(std::move(pattern), english) : replaced(std::move(pattern), italian);
}
/// Adapts it to several bodies taken together.
std::string of_several(std::string pattern, Language language) {
    static constexpr std::array<std::array<std::string_view, 2>, 3> english{
        {{"On body {0}", "On bodies {0}"}, {"on body {0}", "on bodies {0}"}, {"of body {0}", "of bodies {0}"}}};
    static constexpr std::array<std::array<std::string_view, 2>, 3> italian{
        {{"Sul corpo {0}", "Sui corpi {0}"}, {"sul corpo {0}", "sui corpi {0}"}, {"del corpo {0}", "dei corpi {0}"}}};
    return replaced(std::move(pattern), language == Language::en ? english : italian);
}
bool names_several(const BodyName& body) {
    return body.name.find(" + ") != std::string::npos || body.name.find(" … ") != std::string::npos;
}
std::string pattern_of(const Message& message, Language language) {
    std::string pattern(pattern_of(message.sentence, language));
    const auto* body = message.arguments.empty() ? nullptr : std::get_if<BodyName>(&message.arguments.front());
    if (body == nullptr) return pattern;
    if (body->as == BodyName::As::pin) return of_pin(std::move(pattern), language);
    if (body->as == BodyName::As::truss) {
        // A bar that connects the body.
        if (message.sentence == Sentence::two_force_body)
            return language == Language::en ? "Bar {0} carries a force along itself."
                                            : "L’asta {0} è soggetta a solo sforzo assiale.";
        return of_truss(std::move(pattern), language);
    }
    return names_several(*body) ? of_several(std::move(pattern), language) : pattern;
}

bool is_empty(const Argument& arg) {
    if (const auto* text = std::get_if<std::string>(&arg)) return text->empty();
    if (const auto* point = std::get_if<PointName>(&arg)) return point->name.empty();
    if (const auto* body = std::get_if<BodyName>(&arg)) return body->name.empty();
    if (const auto* joint = std::get_if<JointName>(&arg)) return joint->name.empty();
    if (const auto* names = std::get_if<Names>(&arg)) return names->empty();
    if (const auto* symbols = std::get_if<Symbols>(&arg)) return symbols->empty();
    return false;
}

bool is_one(const Argument& arg) {
    if (const auto* count = std::get_if<Count>(&arg)) return count->value == 1;
    if (const auto* names = std::get_if<Names>(&arg)) return names->size() == 1;
    if (const auto* symbols = std::get_if<Symbols>(&arg)) return symbols->size() == 1;
    return false;
}

/// Typesets a pattern with its arguments, part by part.
class PatternSetter {
public:
    PatternSetter(const std::vector<Argument>& arguments, Language language, Setting setting,
                  const BeforeLine& before_line)
        : arguments_(arguments), language_(language), setting_(setting), before_line_(before_line) {}

    /// Text between [ and ] is omitted if one of its arguments is missing.
    RichText set(std::string_view pattern) {
        for (std::size_t i = 0; i < pattern.size();) {
            const char first = pattern[i];
            if (first != '{') behind_point_ = false;
            if (first == '{')
                i = put_place(pattern, i);
            else if (first == '[')
                i = put_optional_part(pattern, i);
            else
                i += put_text(pattern.substr(i));
        }
        flush();
        return std::move(to_);
    }
    bool all_given() const { return all_given_; }

private:
    void flush() {
        if (!plain_text_.empty()) to_.push_back(piece(plain_text_));
        plain_text_.clear();
    }

    /// Handles "{0}" or "{0|is|are}" at `begin`; returns the index after it.
    std::size_t put_place(std::string_view pattern, std::size_t begin) {
        const auto index = static_cast<std::size_t>(pattern[begin + 1] - '0');
        const std::size_t end = pattern.find('}', begin), bar = pattern.find('|', begin);
        const bool given = index < arguments_.size() && !is_empty(arguments_[index]);
        if (bar < end) {
            const std::size_t second = pattern.find('|', bar + 1);
            plain_text_ += given && is_one(arguments_[index]) ? pattern.substr(bar + 1, second - bar - 1)
                                                              : pattern.substr(second + 1, end - second - 1);
        } else if (given) {
            put_argument(arguments_[index]);
        } else {
            all_given_ = false;
        }
        return end + 1;
    }
    void put_argument(const Argument& value) {
        flush();
        const auto* line = std::get_if<LineReason>(&value);
        if (line && before_line_) to_.push_back(piece(before_line_(*line)));
        const bool is_point = std::holds_alternative<PointName>(value);
        const RichText text = argument(value, language_, setting_);
        if (is_point && behind_point_)
            append_point(to_, text);
        else
            append(to_, text);
        behind_point_ = is_point;
    }

    std::size_t put_optional_part(std::string_view pattern, std::size_t begin) {
        const std::size_t end = pattern.find(']', begin);
        flush();
        PatternSetter inner(arguments_, language_, setting_, before_line_);
        const RichText part = inner.set(pattern.substr(begin + 1, end - begin - 1));
        if (inner.all_given()) append(to_, part);
        return end + 1;
    }

    /// Returns how many bytes of `rest` were handled.
    std::size_t put_text(std::string_view rest) {
        constexpr std::string_view omega = "ω", alpha = "α", squared = "²";
        if (rest.starts_with('~')) {
            plain_text_ += setting_ == Setting::typeset ? unbroken_blank : " ";
            return 1;
        }
        if (rest.starts_with(omega)) {
            flush();
            to_.push_back(piece(omega, Face::italic));
            return omega.size();
        }
        if (rest.starts_with(alpha)) {
            flush();
            append(to_, typeset(Symbol{Symbol::Letter::alpha, "", ""}, language_));
            return alpha.size();
        }
        if (rest.starts_with(squared) && plain_text_.empty() && !to_.empty()) {
            to_.back().sup = "2";
            return squared.size();
        }
        plain_text_ += rest.front();
        return 1;
    }

    const std::vector<Argument>& arguments_;
    Language language_;
    Setting setting_;
    BeforeLine before_line_;
    bool all_given_ = true;
    bool behind_point_ = false;  ///< directly: two consecutive points name a line
    std::string plain_text_;
    RichText to_;
};

std::string superscript(int value) {
    static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out;
    for (const char c : std::to_string(value)) out += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    return out;
}

/// A decimal of to_chars in the notation of the language.
std::string dressed(std::string_view decimal, Language language) {
    std::string out;
    for (const char c : decimal) {
        if (c == '-')
            out += "−";
        else if (c == '.')
            out += notation(language).decimal_mark;
        else
            out += c;
    }
    return out;
}

/// "0.64", "1.309": `digits` significant digits, without trailing zeros.
std::string factor(double value, Language language) {
    constexpr int digits = 4;
    std::string text = number(value, digits, Language::en);
    const std::size_t power = std::min(text.find(' '), text.size());
    std::string digits_alone = text.substr(0, power);
    if (digits_alone.find('.') != std::string::npos) {
        digits_alone.erase(digits_alone.find_last_not_of('0') + 1);
        if (digits_alone.ends_with('.')) digits_alone.pop_back();
    }
    return dressed(digits_alone + text.substr(power), language);
}

/// With brackets where a power of ten would merge with its neighbours: (1.2 × 10⁵)², 3/(1.2 × 10⁵).
std::string bracketed(double value, Language language) {
    const std::string text = factor(value, language);
    return text.find(' ') == std::string::npos ? text : "(" + text + ")";
}

/// "−4 · 0.5²": one sign, followed by the moduli of the factors.
std::string product_of(const std::vector<Working::Factor>& factors, Language language) {
    double sense = 1;
    for (const Working::Factor& each : factors) sense *= each.value < 0 && !each.squared ? -1 : 1;
    std::string product = sense < 0 ? "−" : "";
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const double size = std::abs(factors[i].value);
        product += (i > 0 ? std::string(unbroken_blank) + "·" + unbroken_blank : "") +
                   (factors[i].squared ? bracketed(size, language) + "²" : factor(size, language));
    }
    return product;
}

/// "18.89 · 3 − 20 · 4" for forces and arms, "12 − 3.5" for plain summands; a long sum breaks before a sign.
std::string sum_of(const Working& working, Language language) {
    std::string sum;
    for (std::size_t i = 0; i < working.summands.size(); ++i) {
        const double one = i < working.factors.size() ? working.factors[i].value : working.summands[i];
        const char* sign = one < 0 ? "−" : i > 0 ? "+" : "";
        sum += i > 0 ? std::string(" ") + sign + unbroken_blank : std::string(sign);
        sum += factor(std::abs(one), language);
        if (i < working.factors.size())
            sum += std::string(unbroken_blank) + "·" + unbroken_blank + factor(working.summands[i], language);
    }
    return sum;
}

std::string result_of(const Working& working, Language language) {
    constexpr int digits = 3;
    std::string result = number(working.result.value, digits, language);
    if (working.result.value != 0) result += unbroken_blank + unbroken(working.result.unit);
    return result;
}

/// "ω_3 = −0.1963/0.15 = −1.31 rad/s": one sign, followed by the moduli of the factors.
RichText worked_out(const Working& working, Language language) {
    RichText text = typeset(working.of, language);
    for (Piece& each : text)
        if (each.face == Face::bold_italic) each.face = Face::italic;  // the modulus of a vector
    const std::string equals = std::string(unbroken_blank) + "=" + unbroken_blank;
    std::string product = working.summands.empty() ? product_of(working.factors, language) : sum_of(working, language);
    if (working.divisor) product += "/" + bracketed(*working.divisor, language);
    const std::string result = result_of(working, language);
    append(text, with_powers(equals + (product.empty() ? "" : product + " =" + unbroken_blank) + result));
    if (working.turned) {
        append(text, {piece(", ")});
        append(text, typeset(working.turned->velocity, language));
        append(text, {piece(word("turned with", language))});
        append(text, typeset(working.turned->with, language));
    }
    return text;
}

/// In sequence; the same quantity in another unit is appended, "… = −19.8 rad/s = −189 rpm".
std::vector<RichText> worked_out(const std::vector<Working>& worked_arithmetic, Language language) {
    std::vector<RichText> all;
    for (std::size_t i = 0; i < worked_arithmetic.size(); ++i)
        if (i > 0 && worked_arithmetic[i].of == worked_arithmetic[i - 1].of)
            append(all.back(),
                   with_powers(" =" + std::string(unbroken_blank) + result_of(worked_arithmetic[i], language)));
        else
            all.push_back(worked_out(worked_arithmetic[i], language));
    return all;
}

bool is_all_zero(std::string_view decimal) {
    return std::none_of(decimal.begin(), decimal.end(), [](char c) { return c >= '1' && c <= '9'; });
}

}  // namespace

RichText say(const Message& message, Language language) { return say(message, language, {}); }
RichText say(const Message& message, Language language, const BeforeLine& before_line) {
    RichText text =
        PatternSetter(message.arguments, language, Setting::typeset, before_line).set(pattern_of(message, language));
    const std::vector<RichText> worked_arithmetic = worked_out(message.worked_arithmetic, language);
    for (std::size_t i = 0; i < worked_arithmetic.size(); ++i) {
        text.push_back(piece(i == 0 ? " " : "; "));
        append(text, worked_arithmetic[i]);
    }
    if (!message.worked_arithmetic.empty()) text.push_back(piece("."));
    return text;
}

RichText say_likewise(const std::vector<const Message*>& messages, Language language) {
    RichText text = {piece(word("likewise", language) + " ")};
    bool first = true;
    for (const Message* message : messages) {
        const auto part = [&](const RichText& said) {
            if (!std::exchange(first, false)) text.push_back(piece("; "));
            append(text, said);
        };
        for (const RichText& working : worked_out(message->worked_arithmetic, language)) part(working);
        if (!message->worked_arithmetic.empty()) continue;
        // The body, and what it is connected to.
        RichText said = {piece(word("body", language) + unbroken_blank)};
        for (std::size_t i = 0; i < message->arguments.size(); ++i) {
            if (i > 0) said.push_back(piece(i == 1 ? " (" : ", "));
            append(said, argument(message->arguments[i], language, Setting::typeset));
        }
        if (message->arguments.size() > 1) said.push_back(piece(")"));
        part(said);
    }
    text.push_back(piece("."));
    return text;
}

std::string tell(const Message& message, Language language) {
    return plain(PatternSetter(message.arguments, language, Setting::spelt, {}).set(pattern_of(message, language)));
}

/// A load that the file calls P_1 keeps its letter, instead of F with a subscript P_1.
bool has_letter(const Symbol& symbol) {
    const std::string& name = symbol.about;
    return (symbol.letter == Symbol::Letter::F || symbol.letter == Symbol::Letter::M) && name.size() > 2 &&
           name[1] == '_' && std::isupper(static_cast<unsigned char>(name[0])) != 0;
}

RichText typeset(const Symbol& symbol, Language language) {
    using Letter = Symbol::Letter;
    if (symbol.letter == Letter::point || symbol.letter == Letter::length) return point_name(symbol.about);
    if (symbol.letter == Letter::image) return point_name(lower_case(symbol.about) + (symbol.term == "'" ? "'" : ""));
    if (symbol.letter == Letter::body) return {piece(symbol.about)};

    Piece result;
    result.face = Face::italic;
    switch (symbol.letter) {
        case Letter::pole: result.text = "o"; break;
        case Letter::v:
            result.text = "v";
            result.face = Face::bold_italic;
            break;
        case Letter::a:
            result.text = "a";
            result.face = Face::bold_italic;
            break;
        case Letter::omega: result.text = "ω"; break;
        case Letter::alpha:
            result.text = notation(language).alpha;
            result.dots = notation(language).alpha_dots;
            break;
        case Letter::centre: result.text = notation(language).centre; break;
        case Letter::radius: result.text = "ρ"; break;
        case Letter::diameter: result.text = "δ"; break;
        case Letter::error: result.text = "ε"; break;
        case Letter::F:
            result.text = "F";
            result.face = Face::bold_italic;
            break;
        case Letter::M: result.text = "M"; break;
        case Letter::speed:
            result.text = "s";
            result.dots = 1;
            break;
        default: KG_ASSERT(false, "a symbol has a letter");
    }
    result.sub = symbol.about;
    // A force that the file calls F_gas or M keeps its name, instead of F with a subscript F_gas.
    if (has_own_name(symbol)) {
        result.text = result.sub[0];
        result.sub.erase(0, result.sub.find('_') == 1 ? 2 : 1);
    } else if (has_letter(symbol)) {
        result.text = result.sub[0];
        result.sub.erase(0, 2);
    }
    // g (weight) and i (inertia) are abbreviations, not quantities, hence upright.
    const bool of_body = symbol.letter == Letter::F && !result.sub.empty() &&
                         (result.sub[0] == 'g' || result.sub[0] == 'i') &&
                         (result.sub.size() == 1 || digits_only(result.sub.substr(1)));
    result.sub_face = of_body || digits_only(result.sub) ? Face::regular : Face::italic;
    result.sup = symbol.term;
    return {result};
}

RichText typeset(const LineReason& reason, Language language) {
    const bool perpendicular = reason.kind == LineReason::Kind::perpendicular_to_segment ||
                               reason.kind == LineReason::Kind::perpendicular_to_guide;
    if (reason.kind == LineReason::Kind::known) return {piece(word("known", language))};
    RichText text{piece(perpendicular ? "⟂ " : "∥ ")};
    switch (reason.kind) {
        case LineReason::Kind::perpendicular_to_segment:
        case LineReason::Kind::parallel_to_segment:
            append(text, point_name(reason.from));
            append_point(text, point_name(reason.to));
            return text;
        case LineReason::Kind::parallel_to_guide:
        case LineReason::Kind::perpendicular_to_guide: text.back().text += word("guide", language); break;
        case LineReason::Kind::driver_component: text = {piece("⟂ " + word("drive", language))}; break;
        case LineReason::Kind::parallel_to_locus: text.back().text += word("locus", language); break;
        case LineReason::Kind::given_direction: text.back().text += word("given line", language); break;
        case LineReason::Kind::parallel_to_tangent: text.back().text += word("tangent", language); break;
        case LineReason::Kind::parallel_to_normal: text.back().text += word("normal", language); break;
        case LineReason::Kind::known: break;
    }
    if (reason.from.empty()) return text;
    // A name that states its kind needs no word before it: "∥ guide 2".
    if (reason.own_name && reason.from.starts_with(word("guide", language)))
        return {piece((perpendicular ? "⟂ " : "∥ ") + reason.from)};
    text.back().text += " ";
    append(text, reason.own_name ? RichText{piece(reason.from)} : point_name(reason.from));
    return text;
}

std::string number(double value, int digits, Language language) {
    KG_ASSERT(digits >= 1 && digits <= 17, "a number has 1 to 17 digits");
    if (!std::isfinite(value)) return "–";
    if (value == 0) return "0";
    char buffer[64];
    const auto scientific =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, digits - 1);
    std::string_view text(buffer, static_cast<std::size_t>(scientific.ptr - buffer));
    const std::size_t e = text.find('e');
    const int exponent = std::atoi(std::string(text.substr(e + 1)).c_str());
    if (exponent < -3 || exponent >= std::max(digits, 5))
        return dressed(text.substr(0, e), language) + " × 10" + superscript(exponent);
    char fixed_buffer[64];
    const auto end = std::to_chars(fixed_buffer, fixed_buffer + sizeof fixed_buffer, value, std::chars_format::fixed,
                                   std::max(0, digits - 1 - exponent));
    return dressed({fixed_buffer, static_cast<std::size_t>(end.ptr - fixed_buffer)}, language);
}

std::string fixed(double value, int decimals, Language language) {
    if (!std::isfinite(value)) return "–";
    char buffer[400];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
    std::string_view text(buffer, static_cast<std::size_t>(end.ptr - buffer));
    if (text.starts_with('-') && is_all_zero(text)) text.remove_prefix(1);  // no −0.00
    return dressed(text, language);
}

std::string pair_of(const std::string& x, const std::string& y, Language language) {
    return "(" + x + notation(language).between_numbers + y + ")";
}

std::string shortest(double value) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value);
    return {buffer, end.ptr};
}

std::string shortest(double value, Language language) {
    for (int digits = 1; digits < 17; ++digits) {
        const std::string text = number(value, digits, Language::en);
        char buffer[64];
        const auto end =
            std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, digits - 1);
        double back = 0;
        std::from_chars(buffer, end.ptr, back);
        if (back == value) return number(value, digits, language);
    }
    return number(value, 17, language);
}

std::string verdict_words(const Mobility& mobility, Language language) {
    const auto times = [&](std::string_view key) {
        const int count = mobility.repeated();
        return word(key, language) + ", " + std::to_string(count) + " " + word(count == 1 ? "time" : "times", language);
    };
    switch (mobility.verdict()) {
        case Mobility::Verdict::mechanism: return word("verdict mechanism", language);
        case Mobility::Verdict::isostatic: return word("verdict isostatic", language);
        case Mobility::Verdict::hyperstatic: return times("verdict hyperstatic");
        case Mobility::Verdict::labile: return word("verdict labile", language);
    }
    KG_ASSERT(false, "a mobility has a verdict");
}

std::string word(std::string_view key, Language language) {
    for (const FixedWords& row : fixed_words)
        if (row.key == key) return std::string(language == Language::en ? row.en : row.it);
    KG_ASSERT(false, "no words for \"" + std::string(key) + "\"");
}

RichText word(std::string_view key, const std::vector<RichText>& parts, Language language) {
    const std::string pattern = word(key, language);
    RichText text;
    for (std::size_t i = 0; i < pattern.size();) {
        const std::size_t open = std::min(pattern.find('{', i), pattern.size());
        if (open > i) append(text, one_piece(pattern.substr(i, open - i)));
        if (open == pattern.size()) break;
        append(text, parts[at_index(pattern[open + 1] - '0')]);
        i = open + 3;
    }
    return text;
}

}  // namespace kinegraph::render
