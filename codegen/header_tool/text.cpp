// SPDX-License-Identifier: MIT
#include "text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace spear::header_tool {

namespace {

bool identifier_start(unsigned char c) { return std::isalpha(c) || c == '_' || c == '$' || c >= 0x80; }
bool identifier_part(unsigned char c) { return identifier_start(c) || std::isdigit(c); }

void append_utf8(std::string& out, char32_t c) {
    if (c < 0x80) {
        out += static_cast<char>(c);
    } else if (c < 0x800) {
        out += static_cast<char>(0xC0 | (c >> 6));
        out += static_cast<char>(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        out += static_cast<char>(0xE0 | (c >> 12));
        out += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (c & 0x3F));
    } else {
        out += static_cast<char>(0xF0 | (c >> 18));
        out += static_cast<char>(0x80 | ((c >> 12) & 0x3F));
        out += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (c & 0x3F));
    }
}

std::string utf16_to_utf8(std::string_view bytes, bool big_endian) {
    std::string out;
    auto unit = [&](std::size_t i) {
        unsigned char a = static_cast<unsigned char>(bytes[i]), b = static_cast<unsigned char>(bytes[i + 1]);
        return static_cast<char32_t>(big_endian ? (a << 8 | b) : (b << 8 | a));
    };
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
        char32_t c = unit(i);
        if (c >= 0xD800 && c < 0xDC00 && i + 3 < bytes.size()) {
            c = 0x10000 + ((c - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
            i += 2;
        }
        append_utf8(out, c);
    }
    return out;
}

// Length of the valid UTF-8 sequence at `i`, 0 if there is none.
std::size_t utf8_length(std::string_view s, std::size_t i) {
    unsigned char c = static_cast<unsigned char>(s[i]);
    std::size_t n = c < 0x80 ? 1 : (c >> 5) == 6 ? 2 : (c >> 4) == 14 ? 3 : (c >> 3) == 30 ? 4 : 0;
    if (n == 0 || i + n > s.size())
        return 0;
    for (std::size_t k = 1; k < n; ++k)
        if ((static_cast<unsigned char>(s[i + k]) & 0xC0) != 0x80)
            return 0;
    return n;
}

} // namespace

SourceText::SourceText(std::string bytes) : bytes_(std::move(bytes)) {
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < bytes_.size(); ++i)
        if (bytes_[i] == '\n')
            line_starts_.push_back(i + 1);
}

unsigned SourceText::line(std::size_t offset) const {
    auto it = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
    return static_cast<unsigned>(it - line_starts_.begin());
}

unsigned SourceText::column(std::size_t offset) const {
    return static_cast<unsigned>(offset - line_starts_[line(offset) - 1] + 1);
}

bool SourceText::looks_like_text(std::string_view bytes) {
    if (bytes.size() >= 2 && ((bytes[0] == '\xFF' && bytes[1] == '\xFE') || (bytes[0] == '\xFE' && bytes[1] == '\xFF')))
        return bytes.size() % 2 == 0;
    return bytes.find('\0') == std::string_view::npos;
}

std::string SourceText::to_utf8(std::string bytes) {
    if (bytes.size() >= 2 && bytes[0] == '\xFF' && bytes[1] == '\xFE')
        bytes = utf16_to_utf8(bytes, false);
    else if (bytes.size() >= 2 && bytes[0] == '\xFE' && bytes[1] == '\xFF')
        bytes = utf16_to_utf8(bytes, true);
    else if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0)
        bytes.erase(0, 3);
    std::string out;
    out.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size();) {
        if (bytes[i] == '\r') {
            if (i + 1 >= bytes.size() || bytes[i + 1] != '\n')
                out += '\n';
            ++i;
            continue;
        }
        std::size_t n = utf8_length(bytes, i);
        if (n == 0) {
            append_utf8(out, static_cast<unsigned char>(bytes[i]));
            ++i;
        } else {
            out.append(bytes, i, n);
            i += n;
        }
    }
    return out;
}

namespace {

class Lexer {
public:
    Lexer(const SourceText& source, const std::vector<ByteRange>& skipped) : text_(source.bytes()), skipped_(skipped) {}

    LexResult run() {
        while (at_ < text_.size())
            step();
        result_.tokens.insert(result_.tokens.end(), end_token_count, {TokenKind::end, text_.size(), text_.size(), {}});
        return std::move(result_);
    }

private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

    void step() {
        while (next_skip_ < skipped_.size() && skipped_[next_skip_].end <= at_)
            ++next_skip_;
        if (next_skip_ < skipped_.size() && skipped_[next_skip_].contains(at_)) {
            at_ = skipped_[next_skip_].end;
            line_begins_ = true;
            return;
        }
        char c = peek();
        if (c == '\n') {
            line_begins_ = true;
            ++at_;
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            ++at_;
        } else if (c == '\\' && peek(1) == '\n') {
            at_ += 2;
        } else if (c == '/' && peek(1) == '/') {
            line_comment();
        } else if (c == '/' && peek(1) == '*') {
            block_comment();
        } else if (c == '#' && line_begins_) {
            directive();
        } else {
            line_begins_ = false;
            token();
        }
    }

    void line_comment() {
        std::size_t begin = at_;
        while (at_ < text_.size() && (text_[at_] != '\n' || text_[at_ - 1] == '\\'))
            ++at_;
        result_.comments.push_back({begin, at_, false});
    }

    void block_comment() {
        std::size_t begin = at_;
        std::size_t close = text_.find("*/", at_ + 2);
        at_ = close == std::string::npos ? text_.size() : close + 2;
        result_.comments.push_back({begin, at_, true});
    }

    void directive() {
        Directive d;
        d.begin = at_++;
        while (peek() == ' ' || peek() == '\t')
            ++at_;
        while (identifier_part(static_cast<unsigned char>(peek())))
            d.name += text_[at_++];
        while (at_ < text_.size() && text_[at_] != '\n') {
            if (text_[at_] == '\\' && peek(1) == '\n') {
                at_ += 2;
                d.rest += ' ';
            } else if (text_[at_] == '/' && peek(1) == '/') {
                while (at_ < text_.size() && text_[at_] != '\n')
                    ++at_;
            } else if (text_[at_] == '/' && peek(1) == '*') {
                std::size_t close = text_.find("*/", at_ + 2);
                at_ = close == std::string::npos ? text_.size() : close + 2;
                d.rest += ' ';
            } else {
                d.rest += text_[at_++];
            }
        }
        d.end = at_;
        d.rest = std::string(trim(d.rest));
        result_.directives.push_back(std::move(d));
    }

    void push(TokenKind kind, std::size_t begin) {
        result_.tokens.push_back({kind, begin, at_, std::string_view(text_).substr(begin, at_ - begin)});
    }

    void quoted(char quote) {
        ++at_;
        while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n')
            at_ += text_[at_] == '\\' ? 2 : 1;
        at_ = std::min(at_ + 1, text_.size());
    }

    void raw_string() { // at the opening quote of R"delim( ... )delim"
        std::size_t open = text_.find('(', at_);
        if (open == std::string::npos) {
            at_ = text_.size();
            return;
        }
        std::string close = ")" + text_.substr(at_ + 1, open - at_ - 1) + "\"";
        std::size_t found = text_.find(close, open);
        at_ = found == std::string::npos ? text_.size() : found + close.size();
    }

    void token() {
        std::size_t begin = at_;
        unsigned char c = static_cast<unsigned char>(text_[at_]);
        if (identifier_start(c)) {
            while (at_ < text_.size() && identifier_part(static_cast<unsigned char>(text_[at_])))
                ++at_;
            std::string_view word = std::string_view(text_).substr(begin, at_ - begin);
            bool prefix = word == "L" || word == "u" || word == "U" || word == "u8";
            if (peek() == '"' && (word == "R" || word == "LR" || word == "uR" || word == "UR" || word == "u8R")) {
                raw_string();
                push(TokenKind::string, begin);
            } else if (prefix && peek() == '"') {
                quoted('"');
                push(TokenKind::string, begin);
            } else if (prefix && peek() == '\'') {
                quoted('\'');
                push(TokenKind::character, begin);
            } else {
                push(TokenKind::identifier, begin);
            }
        } else if (std::isdigit(c) || (c == '.' && std::isdigit(static_cast<unsigned char>(peek(1))))) {
            while (at_ < text_.size() &&
                   (identifier_part(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.' ||
                       (text_[at_] == '\'' && identifier_part(static_cast<unsigned char>(peek(1)))) ||
                       ((text_[at_] == '+' || text_[at_] == '-') &&
                           std::string_view("eEpP").find(text_[at_ - 1]) != std::string_view::npos &&
                           !(text_[begin] == '0' && (text_[begin + 1] == 'x' || text_[begin + 1] == 'X') &&
                               (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E')))))
                ++at_;
            push(TokenKind::number, begin);
        } else if (c == '"') {
            quoted('"');
            push(TokenKind::string, begin);
        } else if (c == '\'') {
            quoted('\'');
            push(TokenKind::character, begin);
        } else {
            static constexpr std::array<std::string_view, 3> two{"::", "->", "&&"};
            std::string_view rest = std::string_view(text_).substr(at_, 2);
            at_ += std::find(two.begin(), two.end(), rest) != two.end() ? 2 : 1;
            push(TokenKind::punctuation, begin);
        }
    }

    const std::string& text_;
    const std::vector<ByteRange>& skipped_;
    std::size_t next_skip_ = 0;
    std::size_t at_ = 0;
    bool line_begins_ = true;
    LexResult result_;
};

} // namespace

LexResult lex(const SourceText& source, const std::vector<ByteRange>& skipped) { return Lexer(source, skipped).run(); }

std::string strip_comments(std::string_view text) {
    std::string out;
    bool blank = false;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '/' && i + 1 < text.size() && text[i + 1] == '/') {
            while (i < text.size() && text[i] != '\n')
                ++i;
            blank = true;
        } else if (text[i] == '/' && i + 1 < text.size() && text[i + 1] == '*') {
            std::size_t close = text.find("*/", i + 2);
            i = close == std::string_view::npos ? text.size() : close + 2;
            blank = true;
        } else if (std::isspace(static_cast<unsigned char>(text[i])) ||
                   (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '\n')) {
            blank = true;
            ++i;
        } else {
            if (blank && !out.empty())
                out += ' ';
            blank = false;
            if (text[i] == '"' ||
                (text[i] == '\'' && (out.empty() || !identifier_part(static_cast<unsigned char>(out.back()))))) {
                char quote = text[i];
                out += text[i++];
                while (i < text.size() && text[i] != quote) {
                    if (text[i] == '\\' && i + 1 < text.size())
                        out += text[i++];
                    out += text[i++];
                }
                if (i < text.size())
                    out += text[i++];
            } else {
                out += text[i++];
            }
        }
    }
    return out;
}

std::string normalise_spaces(std::string_view text) {
    std::string plain = strip_comments(text);
    std::string out;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        char c = plain[i];
        if (c == ' ') {
            char before = out.empty() ? '\0' : out.back();
            char after = i + 1 < plain.size() ? plain[i + 1] : '\0';
            if (identifier_part(static_cast<unsigned char>(before)) &&
                identifier_part(static_cast<unsigned char>(after)))
                out += ' ';
            else if ((before == '*' || before == '&' || before == '>') &&
                     identifier_part(static_cast<unsigned char>(after)))
                out += ' ';
            continue;
        }
        out += c;
        if (c == ',')
            out += ' ';
    }
    return std::string(trim(out));
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
    return text;
}

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

bool equals_no_case(std::string_view a, std::string_view b) { return a.size() == b.size() && lower(a) == lower(b); }

bool starts_with_no_case(std::string_view text, std::string_view prefix) {
    return text.size() >= prefix.size() && equals_no_case(text.substr(0, prefix.size()), prefix);
}

bool is_macro_like(std::string_view name) {
    bool letter = false;
    for (unsigned char c : name) {
        if (std::isupper(c))
            letter = true;
        else if (!std::isdigit(c) && c != '_')
            return false;
    }
    return letter && name.size() > 1;
}

} // namespace spear::header_tool
