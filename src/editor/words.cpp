// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "editor/actions.h"
#include "editor/message.h"
#include "io/numbers.h"

namespace inkflate {
namespace {

/// What a word says. {0} is an argument, {action} the argument as the label of an action. Where the first argument is a number,
/// forms for different numbers are separated by "|": English 1 and others, Czech 1, 2 to 4 and others.
struct WordText {
  Word word = Word::ClosedGaps;
  std::string_view english;
  std::string_view czech;
};

// In the order of Word.
constexpr WordText kTexts[] = {
    {Word::ClosedGaps, "Closed {0} gap.|Closed {0} gaps.",
     "Uzavřena {0} mezera.|Uzavřeny {0} mezery.|Uzavřeno {0} mezer."},
    {Word::ClosedNoGap, "Simplified. There was no gap to close.",
     "Zjednodušeno. Žádná mezera k uzavření tu nebyla."},
    {Word::LaidOnParts,
     "{0} line now belongs to the part that it lies on.|{0} lines now belong to the parts that "
     "they "
     "lie on.",
     "{0} čára teď patří k části, na které leží.|{0} čáry teď patří k částem, na kterých leží.|{0} "
     "čar "
     "teď patří k částem, na kterých leží."},
    {Word::CopiedBehind, "A copy lies behind all parts.", "Kopie leží za všemi částmi."},
    {Word::CopiedBefore, "A copy lies in front of all parts.", "Kopie leží před všemi částmi."},
    {Word::CopyRemoved, "The copy is gone.", "Kopie je pryč."},
    {Word::Opened, "Opened {0}.", "Otevřeno: {0}."},
    {Word::Saved, "Saved.", "Uloženo."},
    {Word::Exported, "Exported.", "Exportováno."},
    {Word::Recovered, "Your drawing is back as you left it.",
     "Kresba je zpátky tak, jak jste ji opustili."},
    {Word::RecoveredInPart,
     "Your drawing is back, but what was done last is lost: its record was damaged.",
     "Kresba je zpátky, ale poslední úpravy chybí: jejich záznam byl poškozený."},
    {Word::PinSelected, "Pin {0}.", "Špendlík {0}."},
    {Word::Undone, "Undone: {action}.", "Vráceno zpět: {action}."},
    {Word::Redone, "Redone: {action}.", "Provedeno znovu: {action}."},
    {Word::NothingRough, "There are no loose lines to simplify. Draw some first.",
     "Nejsou tu žádné volné čáry ke zjednodušení. Nejdřív něco nakreslete."},
    {Word::NotClosed, "This part is open here: draw a help line or allow larger gaps.",
     "Tady je část otevřená: nakreslete pomocnou čáru nebo povolte větší mezery."},
    {Word::NothingToInflate, "There is no part to inflate yet. Draw a shape and simplify it.",
     "Zatím není co nafouknout. Nakreslete tvar a zjednodušte ho."},
    {Word::NothingSelected, "Select a part first.", "Nejdřív vyberte část."},
    {Word::SeveralSelected, "Several parts are selected: select just one.",
     "Vybráno je několik částí: vyberte jen jednu."},
    {Word::NoPin, "There is no pin here. Click a line with Deform to put one there.",
     "Není tu žádný špendlík. Zapíchnete ho klepnutím na čáru, když deformujete."},
    {Word::NothingToBend, "There is no line here to bend.", "Není tu žádná čára k ohnutí."},
    {Word::PartLocked, "This part is locked.", "Tato část je zamknutá."},
    {Word::NotYetPart, "Pins hold parts. Simplify these lines first.",
     "Špendlíky drží části. Nejdřív tyto čáry zjednodušte."},
    {Word::NothingToUndo, "There is nothing to undo.", "Není co vracet zpět."},
    {Word::NothingToRedo, "There is nothing to redo.", "Není co provést znovu."},
    {Word::CannotRead, "This file cannot be opened: {0}", "Soubor nejde otevřít: {0}"},
    {Word::LeftOut, "Not all of this file could be read: {0}",
     "Soubor se nepodařilo načíst celý: {0}"},
    {Word::CannotDo, "This cannot be done: {0}", "Tohle nejde provést: {0}"},
    {Word::Cancelled, "Cancelled.", "Zrušeno."},
    {Word::ModelFault, "The model cannot be made: {0}", "Model nejde vytvořit: {0}"},
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < std::size(kTexts); ++i) {
    if (kTexts[i].word != static_cast<Word>(i)) return false;
  }
  return std::size(kTexts) == static_cast<std::size_t>(Word::ModelFault) + 1;
}
static_assert(is_in_order());

/// Which form a language has for a number: 0, 1, 2.
int plural_form(std::string_view argument, Language language) {
  auto const count = take_index(argument);
  if (count == 1) return 0;
  if (language == Language::English) return 1;
  return count >= 2 && count <= 4 ? 1 : 2;
}

/// One of the forms that are separated by "|"; the last where there are fewer.
std::string_view take_form(std::string_view text, int form) {
  for (; form > 0; --form) {
    auto const bar = text.find('|');
    if (bar == std::string_view::npos) break;
    text.remove_prefix(bar + 1);
  }
  return text.substr(0, text.find('|'));
}

/// What stands for a placeholder.
std::string_view value_of(std::string_view placeholder, std::string_view argument,
                          Language language) {
  auto const* const action = placeholder == "action" ? find_action(argument) : nullptr;
  return action ? label(*action, language) : argument;
}

}  // namespace

std::string text_of(Message const& message, Language language) {
  auto const& row = kTexts[static_cast<std::size_t>(message.word)];
  std::string_view const argument =
      message.arguments.empty() ? "" : std::string_view(message.arguments[0]);
  auto rest = take_form(language == Language::Czech ? row.czech : row.english,
                        plural_form(argument, language));
  std::string text;
  // In one pass, so that a brace in an argument is only a brace.
  for (auto open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    auto const close = rest.find('}', open);
    text += rest.substr(0, open);
    text += value_of(rest.substr(open + 1, close - open - 1), argument, language);
    rest.remove_prefix(close + 1);
  }
  return text.append(rest);
}

}  // namespace inkflate
