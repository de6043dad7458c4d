struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_11 {
member: array<f32>,
}
struct type_15 {
member: u32,
member_1: u32,
}
struct type_16 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_18 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_19 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_20 {
member: type_5,
member_1: type_5,
}
struct type_21 {
member: type_7,
member_1: u32,
}
struct type_22 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_15,
member_4: u32,
member_5: type_17,
member_6: type_18,
member_7: type_18,
member_8: type_19,
member_9: type_20,
member_10: f32,
member_11: type_17,
member_12: type_4,
member_13: type_9,
member_14: type_21,
member_15: type_21,
member_16: type_21,
member_17: type_21,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_23 {
member: type_22,
}
struct type_25 {
member: vec2<f32>,
member_1: vec2<f32>,
member_2: vec2<f32>,
member_3: vec3<f32>,
member_4: bool,
}
struct type_28 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(3)
var<storage, read_write> global_2: type_28;
@group(0) @binding(1)
var<storage> global_3: type_11;
@group(0) @binding(2)
var<storage> global_4: type_11;
fn function_() {
var local: u32;
var local_1: u32;
var local_2: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
var local_6: u32;
var local_7: u32;
var phi_1725_: i32;
var phi_1757_: i32;
var phi_1841_: u32;
var phi_1902_: u32;
var phi_1963_: u32;
var phi_2024_: u32;
var phi_2086_: u32;
var phi_1758_: i32;
var phi_1726_: i32;
var phi_2135_: type_25;
var phi_2139_: type_25;
var phi_2144_: type_25;
var phi_2148_: type_25;
var phi_2152_: type_25;
var phi_2157_: type_25;
var phi_2162_: type_25;
var phi_2166_: type_25;
var phi_2171_: type_25;
var phi_2175_: type_25;
var phi_2179_: type_25;
var phi_2184_: type_25;
var phi_2189_: type_25;
var phi_2193_: type_25;
var phi_2395_: i32;
var phi_2426_: i32;
var phi_2709_: i32;
var phi_2741_: i32;
var phi_2825_: u32;
var phi_2886_: u32;
var phi_2947_: u32;
var phi_3008_: u32;
var phi_3070_: u32;
var phi_2742_: i32;
var phi_2710_: i32;
var phi_2427_: i32;
var phi_2396_: i32;
switch bitcast<i32>(0u) {
default: {
let _e55 = global;
let _e62 = arrayLength((&global_2.member));
let _e65 = global_1.member.member_2;
let _e71 = (_e55.x + _e65.member);
let _e73 = (_e55.y + _e65.member_1);
if (_e71 < _e65.member_2) {
if (_e73 < _e65.member_3) {
let _e79 = global_1.member.member_8.member_1;
let _e80 = (_e79 == 0u);
if _e80 {
break;
}
let _e81 = (_e73 / _e79);
let _e83 = (_e73 - (_e81 * _e79));
let _e84 = (_e79 + 1u);
let _e86 = select(1u, _e84, (_e84 > 0u));
let _e88 = ((_e81 * _e86) + _e83);
let _e92 = global_1.member.member_8.member;
let _e93 = (_e92 + 1u);
let _e98 = global_1.member.member.member_1;
if _e80 {
break;
}
let _e100 = ((_e93 * _e86) * (_e98 / _e79));
local_6 = _e100;
let _e101 = (_e88 * _e93);
local_7 = (_e101 + _e71);
let _e105 = (f32(bitcast<i32>(_e71)) - 0.5f);
let _e108 = (f32(bitcast<i32>(_e83)) - 0.5f);
let _e109 = local_7;
let _e110 = bitcast<i32>(_e109);
let _e112 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e114 = select(_e112, _e110, (_e110 < _e112));
let _e119 = global_3.member[bitcast<u32>(select(0i, _e114, (_e114 > 0i)))];
let _e120 = local_6;
let _e121 = local_7;
let _e123 = bitcast<i32>((_e120 + _e121));
let _e125 = select(_e112, _e123, (_e123 < _e112));
let _e130 = global_3.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e131 = (_e105 + _e119);
let _e132 = (_e108 + _e130);
let _e133 = local_6;
let _e135 = local_7;
let _e137 = bitcast<i32>(((2u * _e133) + _e135));
let _e139 = select(_e112, _e137, (_e137 < _e112));
let _e144 = global_3.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e145 = local_6;
let _e147 = local_7;
let _e149 = bitcast<i32>(((3u * _e145) + _e147));
let _e151 = select(_e112, _e149, (_e149 < _e112));
let _e156 = global_3.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e157 = (_e105 + _e144);
let _e158 = (_e108 + _e156);
let _e159 = local_6;
let _e161 = local_7;
let _e163 = bitcast<i32>(((4u * _e159) + _e161));
let _e165 = select(_e112, _e163, (_e163 < _e112));
let _e170 = global_3.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e171 = local_6;
let _e173 = local_7;
let _e175 = bitcast<i32>(((5u * _e171) + _e173));
let _e177 = select(_e112, _e175, (_e175 < _e112));
let _e182 = global_3.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e183 = local_6;
let _e185 = local_7;
let _e187 = bitcast<i32>(((6u * _e183) + _e185));
let _e189 = select(_e112, _e187, (_e187 < _e112));
let _e194 = global_3.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = (1f / select(1e-6f, _e194, (_e194 > 1e-6f)));
let _e200 = local_6;
let _e202 = local_7;
let _e204 = bitcast<i32>(((7u * _e200) + _e202));
let _e206 = select(_e112, _e204, (_e204 < _e112));
let _e211 = global_3.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e212 = local_6;
let _e214 = local_7;
let _e216 = bitcast<i32>(((8u * _e212) + _e214));
let _e218 = select(_e112, _e216, (_e216 < _e112));
let _e223 = global_3.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e224 = local_6;
let _e226 = local_7;
let _e228 = bitcast<i32>(((9u * _e224) + _e226));
let _e230 = select(_e112, _e228, (_e228 < _e112));
let _e235 = global_3.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e237 = local_6;
let _e239 = local_7;
let _e241 = bitcast<i32>(((10u * _e237) + _e239));
let _e243 = select(_e112, _e241, (_e241 < _e112));
let _e248 = global_3.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e249 = (_e248 != 0f);
let _e253 = type_25(vec2<f32>(_e131, _e132), vec2<f32>(_e157, _e158), vec2<f32>((_e170 * _e197), (_e182 * _e197)), vec3<f32>(_e211, _e223, _e235), _e249);
let _e254 = (_e71 + 1u);
if _e80 {
break;
}
local_4 = _e100;
local_5 = (_e101 + _e254);
let _e258 = (f32(bitcast<i32>(_e254)) - 0.5f);
let _e259 = local_5;
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e112, _e260, (_e260 < _e112));
let _e267 = global_3.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e268 = local_4;
let _e269 = local_5;
let _e271 = bitcast<i32>((_e268 + _e269));
let _e273 = select(_e112, _e271, (_e271 < _e112));
let _e278 = global_3.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e279 = (_e258 + _e267);
let _e280 = (_e108 + _e278);
let _e281 = local_4;
let _e283 = local_5;
let _e285 = bitcast<i32>(((2u * _e281) + _e283));
let _e287 = select(_e112, _e285, (_e285 < _e112));
let _e292 = global_3.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e293 = local_4;
let _e295 = local_5;
let _e297 = bitcast<i32>(((3u * _e293) + _e295));
let _e299 = select(_e112, _e297, (_e297 < _e112));
let _e304 = global_3.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e305 = (_e258 + _e292);
let _e306 = (_e108 + _e304);
let _e307 = local_4;
let _e309 = local_5;
let _e311 = bitcast<i32>(((4u * _e307) + _e309));
let _e313 = select(_e112, _e311, (_e311 < _e112));
let _e318 = global_3.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e319 = local_4;
let _e321 = local_5;
let _e323 = bitcast<i32>(((5u * _e319) + _e321));
let _e325 = select(_e112, _e323, (_e323 < _e112));
let _e330 = global_3.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e331 = local_4;
let _e333 = local_5;
let _e335 = bitcast<i32>(((6u * _e331) + _e333));
let _e337 = select(_e112, _e335, (_e335 < _e112));
let _e342 = global_3.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = (1f / select(1e-6f, _e342, (_e342 > 1e-6f)));
let _e348 = local_4;
let _e350 = local_5;
let _e352 = bitcast<i32>(((7u * _e348) + _e350));
let _e354 = select(_e112, _e352, (_e352 < _e112));
let _e359 = global_3.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e360 = local_4;
let _e362 = local_5;
let _e364 = bitcast<i32>(((8u * _e360) + _e362));
let _e366 = select(_e112, _e364, (_e364 < _e112));
let _e371 = global_3.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e372 = local_4;
let _e374 = local_5;
let _e376 = bitcast<i32>(((9u * _e372) + _e374));
let _e378 = select(_e112, _e376, (_e376 < _e112));
let _e383 = global_3.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e385 = local_4;
let _e387 = local_5;
let _e389 = bitcast<i32>(((10u * _e385) + _e387));
let _e391 = select(_e112, _e389, (_e389 < _e112));
let _e396 = global_3.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e397 = (_e396 != 0f);
let _e401 = type_25(vec2<f32>(_e279, _e280), vec2<f32>(_e305, _e306), vec2<f32>((_e318 * _e345), (_e330 * _e345)), vec3<f32>(_e359, _e371, _e383), _e397);
if _e80 {
break;
}
local_2 = _e100;
let _e404 = ((_e88 + 1u) * _e93);
local_3 = (_e404 + _e71);
let _e408 = (f32(bitcast<i32>((_e83 + 1u))) - 0.5f);
let _e409 = local_3;
let _e410 = bitcast<i32>(_e409);
let _e412 = select(_e112, _e410, (_e410 < _e112));
let _e417 = global_3.member[bitcast<u32>(select(0i, _e412, (_e412 > 0i)))];
let _e418 = local_2;
let _e419 = local_3;
let _e421 = bitcast<i32>((_e418 + _e419));
let _e423 = select(_e112, _e421, (_e421 < _e112));
let _e428 = global_3.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e429 = (_e105 + _e417);
let _e430 = (_e408 + _e428);
let _e431 = local_2;
let _e433 = local_3;
let _e435 = bitcast<i32>(((2u * _e431) + _e433));
let _e437 = select(_e112, _e435, (_e435 < _e112));
let _e442 = global_3.member[bitcast<u32>(select(0i, _e437, (_e437 > 0i)))];
let _e443 = local_2;
let _e445 = local_3;
let _e447 = bitcast<i32>(((3u * _e443) + _e445));
let _e449 = select(_e112, _e447, (_e447 < _e112));
let _e454 = global_3.member[bitcast<u32>(select(0i, _e449, (_e449 > 0i)))];
let _e455 = (_e105 + _e442);
let _e456 = (_e408 + _e454);
let _e457 = local_2;
let _e459 = local_3;
let _e461 = bitcast<i32>(((4u * _e457) + _e459));
let _e463 = select(_e112, _e461, (_e461 < _e112));
let _e468 = global_3.member[bitcast<u32>(select(0i, _e463, (_e463 > 0i)))];
let _e469 = local_2;
let _e471 = local_3;
let _e473 = bitcast<i32>(((5u * _e469) + _e471));
let _e475 = select(_e112, _e473, (_e473 < _e112));
let _e480 = global_3.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e481 = local_2;
let _e483 = local_3;
let _e485 = bitcast<i32>(((6u * _e481) + _e483));
let _e487 = select(_e112, _e485, (_e485 < _e112));
let _e492 = global_3.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e495 = (1f / select(1e-6f, _e492, (_e492 > 1e-6f)));
let _e498 = local_2;
let _e500 = local_3;
let _e502 = bitcast<i32>(((7u * _e498) + _e500));
let _e504 = select(_e112, _e502, (_e502 < _e112));
let _e509 = global_3.member[bitcast<u32>(select(0i, _e504, (_e504 > 0i)))];
let _e510 = local_2;
let _e512 = local_3;
let _e514 = bitcast<i32>(((8u * _e510) + _e512));
let _e516 = select(_e112, _e514, (_e514 < _e112));
let _e521 = global_3.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e522 = local_2;
let _e524 = local_3;
let _e526 = bitcast<i32>(((9u * _e522) + _e524));
let _e528 = select(_e112, _e526, (_e526 < _e112));
let _e533 = global_3.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e535 = local_2;
let _e537 = local_3;
let _e539 = bitcast<i32>(((10u * _e535) + _e537));
let _e541 = select(_e112, _e539, (_e539 < _e112));
let _e546 = global_3.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e547 = (_e546 != 0f);
let _e551 = type_25(vec2<f32>(_e429, _e430), vec2<f32>(_e455, _e456), vec2<f32>((_e468 * _e495), (_e480 * _e495)), vec3<f32>(_e509, _e521, _e533), _e547);
if _e80 {
break;
}
local = _e100;
local_1 = (_e404 + _e254);
let _e553 = local_1;
let _e554 = bitcast<i32>(_e553);
let _e556 = select(_e112, _e554, (_e554 < _e112));
let _e561 = global_3.member[bitcast<u32>(select(0i, _e556, (_e556 > 0i)))];
let _e562 = local;
let _e563 = local_1;
let _e565 = bitcast<i32>((_e562 + _e563));
let _e567 = select(_e112, _e565, (_e565 < _e112));
let _e572 = global_3.member[bitcast<u32>(select(0i, _e567, (_e567 > 0i)))];
let _e573 = (_e258 + _e561);
let _e574 = (_e408 + _e572);
let _e575 = local;
let _e577 = local_1;
let _e579 = bitcast<i32>(((2u * _e575) + _e577));
let _e581 = select(_e112, _e579, (_e579 < _e112));
let _e586 = global_3.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = local;
let _e589 = local_1;
let _e591 = bitcast<i32>(((3u * _e587) + _e589));
let _e593 = select(_e112, _e591, (_e591 < _e112));
let _e598 = global_3.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e599 = (_e258 + _e586);
let _e600 = (_e408 + _e598);
let _e601 = local;
let _e603 = local_1;
let _e605 = bitcast<i32>(((4u * _e601) + _e603));
let _e607 = select(_e112, _e605, (_e605 < _e112));
let _e612 = global_3.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e613 = local;
let _e615 = local_1;
let _e617 = bitcast<i32>(((5u * _e613) + _e615));
let _e619 = select(_e112, _e617, (_e617 < _e112));
let _e624 = global_3.member[bitcast<u32>(select(0i, _e619, (_e619 > 0i)))];
let _e625 = local;
let _e627 = local_1;
let _e629 = bitcast<i32>(((6u * _e625) + _e627));
let _e631 = select(_e112, _e629, (_e629 < _e112));
let _e636 = global_3.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e639 = (1f / select(1e-6f, _e636, (_e636 > 1e-6f)));
let _e642 = local;
let _e644 = local_1;
let _e646 = bitcast<i32>(((7u * _e642) + _e644));
let _e648 = select(_e112, _e646, (_e646 < _e112));
let _e653 = global_3.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e654 = local;
let _e656 = local_1;
let _e658 = bitcast<i32>(((8u * _e654) + _e656));
let _e660 = select(_e112, _e658, (_e658 < _e112));
let _e665 = global_3.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e666 = local;
let _e668 = local_1;
let _e670 = bitcast<i32>(((9u * _e666) + _e668));
let _e672 = select(_e112, _e670, (_e670 < _e112));
let _e677 = global_3.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e679 = local;
let _e681 = local_1;
let _e683 = bitcast<i32>(((10u * _e679) + _e681));
let _e685 = select(_e112, _e683, (_e683 < _e112));
let _e690 = global_3.member[bitcast<u32>(select(0i, _e685, (_e685 > 0i)))];
let _e691 = (_e690 != 0f);
let _e695 = type_25(vec2<f32>(_e573, _e574), vec2<f32>(_e599, _e600), vec2<f32>((_e612 * _e639), (_e624 * _e639)), vec3<f32>(_e653, _e665, _e677), _e691);
let _e698 = global_1.member.member_10;
let _e738 = !(((((((((_e131 == _e157) && (_e132 == _e158)) && (_e211 == _e698)) && (_e223 == _e698)) && (_e235 == _e698)) && (((((_e279 == _e305) && (_e280 == _e306)) && (_e359 == _e698)) && (_e371 == _e698)) && (_e383 == _e698))) && (((((_e429 == _e455) && (_e430 == _e456)) && (_e509 == _e698)) && (_e521 == _e698)) && (_e533 == _e698))) && (((((_e573 == _e599) && (_e574 == _e600)) && (_e653 == _e698)) && (_e665 == _e698)) && (_e677 == _e698))));
let _e743 = global_1.member.member_9.member.member;
let _e748 = global_1.member.member_9.member.member_1;
let _e753 = global_1.member.member_9.member.member_2;
let _e756 = (1f / select(1e-6f, _e753, (_e753 > 1e-6f)));
let _e757 = (_e743 * _e756);
let _e758 = (_e748 * _e756);
if _e738 {
if (_e86 == 0u) {
break;
}
let _e770 = bitcast<i32>(((_e88 / _e86) * 3u));
let _e772 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e774 = select(_e772, _e770, (_e770 < _e772));
let _e780 = global_4.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e781 = (_e770 + 1i);
let _e783 = select(_e772, _e781, (_e781 < _e772));
let _e789 = global_4.member[bitcast<u32>(select(0i, _e783, (_e783 > 0i)))];
let _e790 = (_e770 + 2i);
let _e792 = select(_e772, _e790, (_e790 < _e772));
let _e798 = global_4.member[bitcast<u32>(select(0i, _e792, (_e792 > 0i)))];
let _e799 = -(_e698);
let _e802 = (1f / select(1e-6f, _e798, (_e798 > 1e-6f)));
let _e807 = bitcast<i32>(_e92);
let _e809 = (0.5f * 1f);
let _e810 = (((((_e157 + _e305) + _e455) + _e599) * 0.25f) - _e809);
let _e811 = (((((_e158 + _e306) + _e456) + _e600) * 0.25f) - _e809);
let _e816 = (_e810 + 0.5f);
let _e818 = select(0f, _e816, (_e816 > 0f));
let _e820 = select(65536f, _e818, (_e818 < 65536f));
let _e827 = select(0i, select(select(i32(_e820), i32(-2147483648), (_e820 < -2147483600f)), 2147483647i, (_e820 > 2147483500f)), (_e820 == _e820));
let _e832 = (_e810 + 1f);
let _e833 = (_e832 + 0.5f);
let _e835 = f32((_e807 - 1i));
let _e837 = select(-1f, _e833, (_e833 > -1f));
let _e839 = select(_e835, _e837, (_e837 < _e835));
let _e846 = select(0i, select(select(i32(_e839), i32(-2147483648), (_e839 < -2147483600f)), 2147483647i, (_e839 > 2147483500f)), (_e839 == _e839));
let _e851 = (_e811 + 1f);
let _e852 = (_e851 + 0.5f);
let _e854 = f32((bitcast<i32>(_e79) - 1i));
let _e856 = select(-1f, _e852, (_e852 > -1f));
let _e858 = select(_e854, _e856, (_e856 < _e854));
let _e865 = select(0i, select(select(i32(_e858), i32(-2147483648), (_e858 < -2147483600f)), 2147483647i, (_e858 > 2147483500f)), (_e858 == _e858));
let _e870 = (_e811 + 0.5f);
let _e872 = select(0f, _e870, (_e870 > 0f));
let _e874 = select(65536f, _e872, (_e872 < 65536f));
let _e881 = select(0i, select(select(i32(_e874), i32(-2147483648), (_e874 < -2147483600f)), 2147483647i, (_e874 > 2147483500f)), (_e874 == _e874));
phi_1725_ = (_e881 - select(0i, 1i, (_e874 < f32(_e881))));
loop {
let _e887 = phi_1725_;
let _e888 = (_e887 <= (_e865 - select(0i, 1i, (_e858 < f32(_e865)))));
if _e888 {
let _e889 = f32(_e887);
let _e890 = (_e889 - 0.5f);
let _e893 = (_e889 + 0.5f);
let _e896 = (select(_e893, _e851, (_e851 < _e893)) - select(_e890, _e811, (_e811 > _e890)));
phi_1757_ = (_e827 - select(0i, 1i, (_e820 < f32(_e827))));
loop {
let _e901 = phi_1757_;
let _e902 = (_e901 <= (_e846 - select(0i, 1i, (_e839 < f32(_e846)))));
if _e902 {
let _e903 = f32(_e901);
let _e904 = (_e903 - 0.5f);
let _e907 = (_e903 + 0.5f);
let _e910 = (select(_e907, _e832, (_e832 < _e907)) - select(_e904, _e810, (_e810 > _e904)));
let _e914 = ((select(0f, _e910, (_e910 > 0f)) / 1f) * (select(0f, _e896, (_e896 > 0f)) / 1f));
if (_e914 > 0f) {
let _e918 = (((_e887 * _e807) + _e901) * 10i);
let _e921 = (((_e799 * _e914) * 16777216f) + 0.5f);
let _e923 = select(-1073741800f, _e921, (_e921 > -1073741800f));
let _e925 = select(1073741800f, _e923, (_e923 < 1073741800f));
let _e932 = select(0i, select(select(i32(_e925), i32(-2147483648), (_e925 < -2147483600f)), 2147483647i, (_e925 > 2147483500f)), (_e925 == _e925));
let _e936 = (_e932 - select(0i, 1i, (_e925 < f32(_e932))));
let _e937 = bitcast<u32>(_e936);
let _e940 = bitcast<u32>((_e936 >> bitcast<u32>(31i)));
let _e942 = ((_e937 | _e940) == 0u);
if _e942 {
} else {
let _e943 = bitcast<u32>(_e918);
if (_e943 < _e62) {
let _e947 = atomicAdd((&global_2.member[_e943]), _e937);
phi_1841_ = _e947;
} else {
phi_1841_ = 0u;
}
let _e949 = phi_1841_;
let _e953 = (_e940 + select(0u, 1u, ((_e949 + _e937) < _e937)));
if (_e953 == 0u) {
} else {
let _e955 = (_e943 + 1u);
if (_e955 < _e62) {
let _e959 = atomicAdd((&global_2.member[_e955]), _e953);
}
}
}
if _e942 {
} else {
let _e961 = bitcast<u32>((_e918 + 2i));
if (_e961 < _e62) {
let _e965 = atomicAdd((&global_2.member[_e961]), _e937);
phi_1902_ = _e965;
} else {
phi_1902_ = 0u;
}
let _e967 = phi_1902_;
let _e971 = (_e940 + select(0u, 1u, ((_e967 + _e937) < _e937)));
if (_e971 == 0u) {
} else {
let _e973 = (_e961 + 1u);
if (_e973 < _e62) {
let _e977 = atomicAdd((&global_2.member[_e973]), _e971);
}
}
}
if _e942 {
} else {
let _e979 = bitcast<u32>((_e918 + 4i));
if (_e979 < _e62) {
let _e983 = atomicAdd((&global_2.member[_e979]), _e937);
phi_1963_ = _e983;
} else {
phi_1963_ = 0u;
}
let _e985 = phi_1963_;
let _e989 = (_e940 + select(0u, 1u, ((_e985 + _e937) < _e937)));
if (_e989 == 0u) {
} else {
let _e991 = (_e979 + 1u);
if (_e991 < _e62) {
let _e995 = atomicAdd((&global_2.member[_e991]), _e989);
}
}
}
let _e997 = ((((_e799 + _e799) + _e799) * (1f / 3f)) * _e914);
let _e1000 = (((_e997 * ((_e780 * _e802) - _e757)) * 8388608f) + 0.5f);
let _e1002 = select(-1073741800f, _e1000, (_e1000 > -1073741800f));
let _e1004 = select(1073741800f, _e1002, (_e1002 < 1073741800f));
let _e1011 = select(0i, select(select(i32(_e1004), i32(-2147483648), (_e1004 < -2147483600f)), 2147483647i, (_e1004 > 2147483500f)), (_e1004 == _e1004));
let _e1015 = (_e1011 - select(0i, 1i, (_e1004 < f32(_e1011))));
let _e1016 = bitcast<u32>(_e1015);
let _e1019 = bitcast<u32>((_e1015 >> bitcast<u32>(31i)));
if ((_e1016 | _e1019) == 0u) {
} else {
let _e1022 = bitcast<u32>((_e918 + 6i));
if (_e1022 < _e62) {
let _e1026 = atomicAdd((&global_2.member[_e1022]), _e1016);
phi_2024_ = _e1026;
} else {
phi_2024_ = 0u;
}
let _e1028 = phi_2024_;
let _e1032 = (_e1019 + select(0u, 1u, ((_e1028 + _e1016) < _e1016)));
if (_e1032 == 0u) {
} else {
let _e1034 = (_e1022 + 1u);
if (_e1034 < _e62) {
let _e1038 = atomicAdd((&global_2.member[_e1034]), _e1032);
}
}
}
let _e1042 = (((_e997 * ((_e789 * _e802) - _e758)) * 8388608f) + 0.5f);
let _e1044 = select(-1073741800f, _e1042, (_e1042 > -1073741800f));
let _e1046 = select(1073741800f, _e1044, (_e1044 < 1073741800f));
let _e1053 = select(0i, select(select(i32(_e1046), i32(-2147483648), (_e1046 < -2147483600f)), 2147483647i, (_e1046 > 2147483500f)), (_e1046 == _e1046));
let _e1057 = (_e1053 - select(0i, 1i, (_e1046 < f32(_e1053))));
let _e1058 = bitcast<u32>(_e1057);
let _e1061 = bitcast<u32>((_e1057 >> bitcast<u32>(31i)));
if ((_e1058 | _e1061) == 0u) {
} else {
let _e1064 = bitcast<u32>((_e918 + 8i));
if (_e1064 < _e62) {
let _e1068 = atomicAdd((&global_2.member[_e1064]), _e1058);
phi_2086_ = _e1068;
} else {
phi_2086_ = 0u;
}
let _e1070 = phi_2086_;
let _e1074 = (_e1061 + select(0u, 1u, ((_e1070 + _e1058) < _e1058)));
if (_e1074 == 0u) {
} else {
let _e1076 = (_e1064 + 1u);
if (_e1076 < _e62) {
let _e1080 = atomicAdd((&global_2.member[_e1076]), _e1074);
}
}
}
}
phi_1758_ = (_e901 + 1i);
} else {
phi_1758_ = i32();
}
let _e1083 = phi_1758_;
continue;
continuing {
phi_1757_ = _e1083;
break if !(_e902);
}
}
phi_1726_ = (_e887 + 1i);
} else {
phi_1726_ = i32();
}
let _e1087 = phi_1726_;
continue;
continuing {
phi_1725_ = _e1087;
break if !(_e888);
}
}
}
let _e1099 = (((select(0f, 1f, !(_e249)) + select(0f, 1f, !(_e397))) + select(0f, 1f, !(_e547))) + select(0f, 1f, !(_e691)));
if (_e738 && (_e1099 > 0f)) {
if _e249 {
phi_2135_ = _e551;
} else {
phi_2135_ = _e253;
}
let _e1103 = phi_2135_;
if _e397 {
phi_2139_ = _e695;
} else {
phi_2139_ = _e401;
}
let _e1105 = phi_2139_;
if _e1103.member_4 {
phi_2144_ = _e1105;
} else {
phi_2144_ = _e1103;
}
let _e1108 = phi_2144_;
if _e397 {
phi_2148_ = _e1108;
} else {
phi_2148_ = _e401;
}
let _e1110 = phi_2148_;
if _e249 {
phi_2152_ = _e1110;
} else {
phi_2152_ = _e253;
}
let _e1112 = phi_2152_;
if _e1105.member_4 {
phi_2157_ = _e1103;
} else {
phi_2157_ = _e1105;
}
let _e1115 = phi_2157_;
if _e1112.member_4 {
phi_2162_ = _e1115;
} else {
phi_2162_ = _e1112;
}
let _e1118 = phi_2162_;
if _e397 {
phi_2166_ = _e1118;
} else {
phi_2166_ = _e401;
}
let _e1120 = phi_2166_;
if _e1103.member_4 {
phi_2171_ = _e1105;
} else {
phi_2171_ = _e1103;
}
let _e1122 = phi_2171_;
if _e691 {
phi_2175_ = _e1122;
} else {
phi_2175_ = _e695;
}
let _e1124 = phi_2175_;
if _e547 {
phi_2179_ = _e1124;
} else {
phi_2179_ = _e551;
}
let _e1126 = phi_2179_;
if _e1105.member_4 {
phi_2184_ = _e1103;
} else {
phi_2184_ = _e1105;
}
let _e1128 = phi_2184_;
if _e1126.member_4 {
phi_2189_ = _e1128;
} else {
phi_2189_ = _e1126;
}
let _e1131 = phi_2189_;
if _e691 {
phi_2193_ = _e1131;
} else {
phi_2193_ = _e695;
}
let _e1133 = phi_2193_;
let _e1142 = (_e1120.member.x - _e1112.member.x);
let _e1143 = (_e1120.member.y - _e1112.member.y);
let _e1146 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
let _e1149 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
let _e1160 = (_e1133.member.x - _e1126.member.x);
let _e1161 = (_e1133.member.y - _e1126.member.y);
let _e1164 = bitcast<f32>((bitcast<u32>(_e1160) & 2147483647u));
let _e1167 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
let _e1169 = select(_e1167, _e1164, (_e1164 > _e1167));
let _e1172 = (select(_e1169, _e1151, (_e1151 > _e1169)) - 1e-3f);
let _e1173 = (64f - 1f);
let _e1175 = select(0f, _e1172, (_e1172 > 0f));
let _e1177 = select(_e1173, _e1175, (_e1175 < _e1173));
let _e1184 = select(0i, select(select(i32(_e1177), i32(-2147483648), (_e1177 < -2147483600f)), 2147483647i, (_e1177 > 2147483500f)), (_e1177 == _e1177));
let _e1190 = f32((1i + (_e1184 - select(0i, 1i, (_e1177 < f32(_e1184))))));
let _e1191 = (_e1126.member.x - _e1112.member.x);
let _e1192 = (_e1126.member.y - _e1112.member.y);
let _e1195 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
let _e1198 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
let _e1200 = select(_e1198, _e1195, (_e1195 > _e1198));
let _e1201 = (_e1133.member.x - _e1120.member.x);
let _e1202 = (_e1133.member.y - _e1120.member.y);
let _e1205 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
let _e1208 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
let _e1213 = (select(_e1210, _e1200, (_e1200 > _e1210)) - 1e-3f);
let _e1215 = select(0f, _e1213, (_e1213 > 0f));
let _e1217 = select(_e1173, _e1215, (_e1215 < _e1173));
let _e1224 = select(0i, select(select(i32(_e1217), i32(-2147483648), (_e1217 < -2147483600f)), 2147483647i, (_e1217 > 2147483500f)), (_e1217 == _e1217));
let _e1230 = f32((1i + (_e1224 - select(0i, 1i, (_e1217 < f32(_e1224))))));
let _e1232 = (64f / (_e1190 * _e1230));
let _e1234 = select(_e1232, 1f, (1f < _e1232));
let _e1237 = sqrt(select(0f, _e1234, (_e1234 > 0f)));
let _e1238 = (_e1190 * _e1237);
let _e1240 = select(1f, _e1238, (_e1238 > 1f));
let _e1242 = select(64f, _e1240, (_e1240 < 64f));
let _e1249 = select(0i, select(select(i32(_e1242), i32(-2147483648), (_e1242 < -2147483600f)), 2147483647i, (_e1242 > 2147483500f)), (_e1242 == _e1242));
let _e1253 = (_e1249 - select(0i, 1i, (_e1242 < f32(_e1249))));
let _e1254 = (_e1230 * _e1237);
let _e1256 = select(1f, _e1254, (_e1254 > 1f));
let _e1258 = select(64f, _e1256, (_e1256 < 64f));
let _e1265 = select(0i, select(select(i32(_e1258), i32(-2147483648), (_e1258 < -2147483600f)), 2147483647i, (_e1258 > 2147483500f)), (_e1258 == _e1258));
let _e1269 = (_e1265 - select(0i, 1i, (_e1258 < f32(_e1265))));
let _e1271 = (1f / f32(_e1253));
let _e1273 = (1f / f32(_e1269));
let _e1276 = ((_e1271 * _e1273) * (_e1099 * 0.25f));
phi_2395_ = 0i;
loop {
let _e1278 = phi_2395_;
let _e1279 = (_e1278 < _e1269);
if _e1279 {
let _e1282 = ((f32(_e1278) + 0.5f) * _e1273);
phi_2426_ = 0i;
loop {
let _e1290 = phi_2426_;
let _e1291 = (_e1290 < _e1253);
if _e1291 {
let _e1294 = ((f32(_e1290) + 0.5f) * _e1271);
let _e1309 = ((bitcast<f32>((bitcast<u32>((_e1142 + ((_e1160 - _e1142) * _e1282))) & 2147483647u)) * _e1271) + (bitcast<f32>((bitcast<u32>((_e1191 + ((_e1201 - _e1191) * _e1294))) & 2147483647u)) * _e1273));
let _e1318 = ((bitcast<f32>((bitcast<u32>((_e1143 + ((_e1161 - _e1143) * _e1282))) & 2147483647u)) * _e1271) + (bitcast<f32>((bitcast<u32>((_e1192 + ((_e1202 - _e1192) * _e1294))) & 2147483647u)) * _e1273));
let _e1320 = (_e1112.member.x + (_e1142 * _e1294));
let _e1327 = (_e1112.member.y + (_e1143 * _e1294));
let _e1343 = (_e1112.member_3.x + ((_e1120.member_3.x - _e1112.member_3.x) * _e1294));
let _e1350 = ((_e1343 + (((_e1126.member_3.x + ((_e1133.member_3.x - _e1126.member_3.x) * _e1294)) - _e1343) * _e1282)) * _e1276);
let _e1361 = (_e1112.member_3.y + ((_e1120.member_3.y - _e1112.member_3.y) * _e1294));
let _e1368 = ((_e1361 + (((_e1126.member_3.y + ((_e1133.member_3.y - _e1126.member_3.y) * _e1294)) - _e1361) * _e1282)) * _e1276);
let _e1379 = (_e1112.member_3.z + ((_e1120.member_3.z - _e1112.member_3.z) * _e1294));
let _e1386 = ((_e1379 + (((_e1126.member_3.z + ((_e1133.member_3.z - _e1126.member_3.z) * _e1294)) - _e1379) * _e1282)) * _e1276);
let _e1397 = (_e1112.member_2.x + ((_e1120.member_2.x - _e1112.member_2.x) * _e1294));
let _e1414 = (_e1112.member_2.y + ((_e1120.member_2.y - _e1112.member_2.y) * _e1294));
let _e1423 = bitcast<i32>(_e92);
let _e1426 = select(9.765625e-4f, _e1309, (_e1309 > 9.765625e-4f));
let _e1428 = select(4f, _e1426, (_e1426 < 4f));
let _e1430 = select(9.765625e-4f, _e1318, (_e1318 > 9.765625e-4f));
let _e1432 = select(4f, _e1430, (_e1430 < 4f));
let _e1434 = ((_e1320 + (((_e1126.member.x + (_e1160 * _e1294)) - _e1320) * _e1282)) - (0.5f * _e1428));
let _e1436 = ((_e1327 + (((_e1126.member.y + (_e1161 * _e1294)) - _e1327) * _e1282)) - (0.5f * _e1432));
let _e1441 = (_e1434 + 0.5f);
let _e1443 = select(0f, _e1441, (_e1441 > 0f));
let _e1445 = select(65536f, _e1443, (_e1443 < 65536f));
let _e1452 = select(0i, select(select(i32(_e1445), i32(-2147483648), (_e1445 < -2147483600f)), 2147483647i, (_e1445 > 2147483500f)), (_e1445 == _e1445));
let _e1457 = (_e1434 + _e1428);
let _e1458 = (_e1457 + 0.5f);
let _e1460 = f32((_e1423 - 1i));
let _e1462 = select(-1f, _e1458, (_e1458 > -1f));
let _e1464 = select(_e1460, _e1462, (_e1462 < _e1460));
let _e1471 = select(0i, select(select(i32(_e1464), i32(-2147483648), (_e1464 < -2147483600f)), 2147483647i, (_e1464 > 2147483500f)), (_e1464 == _e1464));
let _e1476 = (_e1436 + _e1432);
let _e1477 = (_e1476 + 0.5f);
let _e1479 = f32((bitcast<i32>(_e79) - 1i));
let _e1481 = select(-1f, _e1477, (_e1477 > -1f));
let _e1483 = select(_e1479, _e1481, (_e1481 < _e1479));
let _e1490 = select(0i, select(select(i32(_e1483), i32(-2147483648), (_e1483 < -2147483600f)), 2147483647i, (_e1483 > 2147483500f)), (_e1483 == _e1483));
let _e1495 = (_e1436 + 0.5f);
let _e1497 = select(0f, _e1495, (_e1495 > 0f));
let _e1499 = select(65536f, _e1497, (_e1497 < 65536f));
let _e1506 = select(0i, select(select(i32(_e1499), i32(-2147483648), (_e1499 < -2147483600f)), 2147483647i, (_e1499 > 2147483500f)), (_e1499 == _e1499));
phi_2709_ = (_e1506 - select(0i, 1i, (_e1499 < f32(_e1506))));
loop {
let _e1512 = phi_2709_;
let _e1513 = (_e1512 <= (_e1490 - select(0i, 1i, (_e1483 < f32(_e1490)))));
if _e1513 {
let _e1514 = f32(_e1512);
let _e1515 = (_e1514 - 0.5f);
let _e1518 = (_e1514 + 0.5f);
let _e1521 = (select(_e1518, _e1476, (_e1476 < _e1518)) - select(_e1515, _e1436, (_e1436 > _e1515)));
phi_2741_ = (_e1452 - select(0i, 1i, (_e1445 < f32(_e1452))));
loop {
let _e1526 = phi_2741_;
let _e1527 = (_e1526 <= (_e1471 - select(0i, 1i, (_e1464 < f32(_e1471)))));
if _e1527 {
let _e1528 = f32(_e1526);
let _e1529 = (_e1528 - 0.5f);
let _e1532 = (_e1528 + 0.5f);
let _e1535 = (select(_e1532, _e1457, (_e1457 < _e1532)) - select(_e1529, _e1434, (_e1434 > _e1529)));
let _e1539 = ((select(0f, _e1535, (_e1535 > 0f)) / _e1428) * (select(0f, _e1521, (_e1521 > 0f)) / _e1432));
if (_e1539 > 0f) {
let _e1543 = (((_e1512 * _e1423) + _e1526) * 10i);
let _e1546 = (((_e1350 * _e1539) * 16777216f) + 0.5f);
let _e1548 = select(-1073741800f, _e1546, (_e1546 > -1073741800f));
let _e1550 = select(1073741800f, _e1548, (_e1548 < 1073741800f));
let _e1557 = select(0i, select(select(i32(_e1550), i32(-2147483648), (_e1550 < -2147483600f)), 2147483647i, (_e1550 > 2147483500f)), (_e1550 == _e1550));
let _e1561 = (_e1557 - select(0i, 1i, (_e1550 < f32(_e1557))));
let _e1562 = bitcast<u32>(_e1561);
let _e1565 = bitcast<u32>((_e1561 >> bitcast<u32>(31i)));
if ((_e1562 | _e1565) == 0u) {
} else {
let _e1568 = bitcast<u32>(_e1543);
if (_e1568 < _e62) {
let _e1572 = atomicAdd((&global_2.member[_e1568]), _e1562);
phi_2825_ = _e1572;
} else {
phi_2825_ = 0u;
}
let _e1574 = phi_2825_;
let _e1578 = (_e1565 + select(0u, 1u, ((_e1574 + _e1562) < _e1562)));
if (_e1578 == 0u) {
} else {
let _e1580 = (_e1568 + 1u);
if (_e1580 < _e62) {
let _e1584 = atomicAdd((&global_2.member[_e1580]), _e1578);
}
}
}
let _e1588 = (((_e1368 * _e1539) * 16777216f) + 0.5f);
let _e1590 = select(-1073741800f, _e1588, (_e1588 > -1073741800f));
let _e1592 = select(1073741800f, _e1590, (_e1590 < 1073741800f));
let _e1599 = select(0i, select(select(i32(_e1592), i32(-2147483648), (_e1592 < -2147483600f)), 2147483647i, (_e1592 > 2147483500f)), (_e1592 == _e1592));
let _e1603 = (_e1599 - select(0i, 1i, (_e1592 < f32(_e1599))));
let _e1604 = bitcast<u32>(_e1603);
let _e1607 = bitcast<u32>((_e1603 >> bitcast<u32>(31i)));
if ((_e1604 | _e1607) == 0u) {
} else {
let _e1610 = bitcast<u32>((_e1543 + 2i));
if (_e1610 < _e62) {
let _e1614 = atomicAdd((&global_2.member[_e1610]), _e1604);
phi_2886_ = _e1614;
} else {
phi_2886_ = 0u;
}
let _e1616 = phi_2886_;
let _e1620 = (_e1607 + select(0u, 1u, ((_e1616 + _e1604) < _e1604)));
if (_e1620 == 0u) {
} else {
let _e1622 = (_e1610 + 1u);
if (_e1622 < _e62) {
let _e1626 = atomicAdd((&global_2.member[_e1622]), _e1620);
}
}
}
let _e1630 = (((_e1386 * _e1539) * 16777216f) + 0.5f);
let _e1632 = select(-1073741800f, _e1630, (_e1630 > -1073741800f));
let _e1634 = select(1073741800f, _e1632, (_e1632 < 1073741800f));
let _e1641 = select(0i, select(select(i32(_e1634), i32(-2147483648), (_e1634 < -2147483600f)), 2147483647i, (_e1634 > 2147483500f)), (_e1634 == _e1634));
let _e1645 = (_e1641 - select(0i, 1i, (_e1634 < f32(_e1641))));
let _e1646 = bitcast<u32>(_e1645);
let _e1649 = bitcast<u32>((_e1645 >> bitcast<u32>(31i)));
if ((_e1646 | _e1649) == 0u) {
} else {
let _e1652 = bitcast<u32>((_e1543 + 4i));
if (_e1652 < _e62) {
let _e1656 = atomicAdd((&global_2.member[_e1652]), _e1646);
phi_2947_ = _e1656;
} else {
phi_2947_ = 0u;
}
let _e1658 = phi_2947_;
let _e1662 = (_e1649 + select(0u, 1u, ((_e1658 + _e1646) < _e1646)));
if (_e1662 == 0u) {
} else {
let _e1664 = (_e1652 + 1u);
if (_e1664 < _e62) {
let _e1668 = atomicAdd((&global_2.member[_e1664]), _e1662);
}
}
}
let _e1670 = ((((_e1350 + _e1368) + _e1386) * (1f / 3f)) * _e1539);
let _e1673 = (((_e1670 * ((_e1397 + (((_e1126.member_2.x + ((_e1133.member_2.x - _e1126.member_2.x) * _e1294)) - _e1397) * _e1282)) - _e757)) * 8388608f) + 0.5f);
let _e1675 = select(-1073741800f, _e1673, (_e1673 > -1073741800f));
let _e1677 = select(1073741800f, _e1675, (_e1675 < 1073741800f));
let _e1684 = select(0i, select(select(i32(_e1677), i32(-2147483648), (_e1677 < -2147483600f)), 2147483647i, (_e1677 > 2147483500f)), (_e1677 == _e1677));
let _e1688 = (_e1684 - select(0i, 1i, (_e1677 < f32(_e1684))));
let _e1689 = bitcast<u32>(_e1688);
let _e1692 = bitcast<u32>((_e1688 >> bitcast<u32>(31i)));
if ((_e1689 | _e1692) == 0u) {
} else {
let _e1695 = bitcast<u32>((_e1543 + 6i));
if (_e1695 < _e62) {
let _e1699 = atomicAdd((&global_2.member[_e1695]), _e1689);
phi_3008_ = _e1699;
} else {
phi_3008_ = 0u;
}
let _e1701 = phi_3008_;
let _e1705 = (_e1692 + select(0u, 1u, ((_e1701 + _e1689) < _e1689)));
if (_e1705 == 0u) {
} else {
let _e1707 = (_e1695 + 1u);
if (_e1707 < _e62) {
let _e1711 = atomicAdd((&global_2.member[_e1707]), _e1705);
}
}
}
let _e1715 = (((_e1670 * ((_e1414 + (((_e1126.member_2.y + ((_e1133.member_2.y - _e1126.member_2.y) * _e1294)) - _e1414) * _e1282)) - _e758)) * 8388608f) + 0.5f);
let _e1717 = select(-1073741800f, _e1715, (_e1715 > -1073741800f));
let _e1719 = select(1073741800f, _e1717, (_e1717 < 1073741800f));
let _e1726 = select(0i, select(select(i32(_e1719), i32(-2147483648), (_e1719 < -2147483600f)), 2147483647i, (_e1719 > 2147483500f)), (_e1719 == _e1719));
let _e1730 = (_e1726 - select(0i, 1i, (_e1719 < f32(_e1726))));
let _e1731 = bitcast<u32>(_e1730);
let _e1734 = bitcast<u32>((_e1730 >> bitcast<u32>(31i)));
if ((_e1731 | _e1734) == 0u) {
} else {
let _e1737 = bitcast<u32>((_e1543 + 8i));
if (_e1737 < _e62) {
let _e1741 = atomicAdd((&global_2.member[_e1737]), _e1731);
phi_3070_ = _e1741;
} else {
phi_3070_ = 0u;
}
let _e1743 = phi_3070_;
let _e1747 = (_e1734 + select(0u, 1u, ((_e1743 + _e1731) < _e1731)));
if (_e1747 == 0u) {
} else {
let _e1749 = (_e1737 + 1u);
if (_e1749 < _e62) {
let _e1753 = atomicAdd((&global_2.member[_e1749]), _e1747);
}
}
}
}
phi_2742_ = (_e1526 + 1i);
} else {
phi_2742_ = i32();
}
let _e1756 = phi_2742_;
continue;
continuing {
phi_2741_ = _e1756;
break if !(_e1527);
}
}
phi_2710_ = (_e1512 + 1i);
} else {
phi_2710_ = i32();
}
let _e1760 = phi_2710_;
continue;
continuing {
phi_2709_ = _e1760;
break if !(_e1513);
}
}
phi_2427_ = (_e1290 + 1i);
} else {
phi_2427_ = i32();
}
let _e1764 = phi_2427_;
continue;
continuing {
phi_2426_ = _e1764;
break if !(_e1291);
}
}
phi_2396_ = (_e1278 + 1i);
} else {
phi_2396_ = i32();
}
let _e1768 = phi_2396_;
continue;
continuing {
phi_2395_ = _e1768;
break if !(_e1279);
}
}
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
