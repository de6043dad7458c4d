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
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(2)
var<storage> global_3: type_11;
@group(0) @binding(3)
var<storage, read_write> global_4: type_28;
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
var phi_1838_: u32;
var phi_1899_: u32;
var phi_1960_: u32;
var phi_2021_: u32;
var phi_2083_: u32;
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
var phi_2822_: u32;
var phi_2883_: u32;
var phi_2944_: u32;
var phi_3005_: u32;
var phi_3067_: u32;
var phi_2742_: i32;
var phi_2710_: i32;
var phi_2427_: i32;
var phi_2396_: i32;
switch bitcast<i32>(0u) {
default: {
let _e55 = global;
let _e62 = arrayLength((&global_4.member));
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
let _e112 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e114 = select(_e112, _e110, (_e110 < _e112));
let _e119 = global_2.member[bitcast<u32>(select(0i, _e114, (_e114 > 0i)))];
let _e120 = local_6;
let _e121 = local_7;
let _e123 = bitcast<i32>((_e120 + _e121));
let _e125 = select(_e112, _e123, (_e123 < _e112));
let _e130 = global_2.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e131 = (_e105 + _e119);
let _e132 = (_e108 + _e130);
let _e133 = local_6;
let _e135 = local_7;
let _e137 = bitcast<i32>(((2u * _e133) + _e135));
let _e139 = select(_e112, _e137, (_e137 < _e112));
let _e144 = global_2.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e145 = local_6;
let _e147 = local_7;
let _e149 = bitcast<i32>(((3u * _e145) + _e147));
let _e151 = select(_e112, _e149, (_e149 < _e112));
let _e156 = global_2.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e157 = (_e105 + _e144);
let _e158 = (_e108 + _e156);
let _e159 = local_6;
let _e161 = local_7;
let _e163 = bitcast<i32>(((4u * _e159) + _e161));
let _e165 = select(_e112, _e163, (_e163 < _e112));
let _e170 = global_2.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e171 = local_6;
let _e173 = local_7;
let _e175 = bitcast<i32>(((5u * _e171) + _e173));
let _e177 = select(_e112, _e175, (_e175 < _e112));
let _e182 = global_2.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e183 = local_6;
let _e185 = local_7;
let _e187 = bitcast<i32>(((6u * _e183) + _e185));
let _e189 = select(_e112, _e187, (_e187 < _e112));
let _e194 = global_2.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = (1f / select(1e-6f, _e194, (_e194 > 1e-6f)));
let _e200 = local_6;
let _e202 = local_7;
let _e204 = bitcast<i32>(((7u * _e200) + _e202));
let _e206 = select(_e112, _e204, (_e204 < _e112));
let _e211 = global_2.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e212 = local_6;
let _e214 = local_7;
let _e216 = bitcast<i32>(((8u * _e212) + _e214));
let _e218 = select(_e112, _e216, (_e216 < _e112));
let _e223 = global_2.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e224 = local_6;
let _e226 = local_7;
let _e228 = bitcast<i32>(((9u * _e224) + _e226));
let _e230 = select(_e112, _e228, (_e228 < _e112));
let _e235 = global_2.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e237 = local_6;
let _e239 = local_7;
let _e241 = bitcast<i32>(((10u * _e237) + _e239));
let _e243 = select(_e112, _e241, (_e241 < _e112));
let _e248 = global_2.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
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
let _e267 = global_2.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e268 = local_4;
let _e269 = local_5;
let _e271 = bitcast<i32>((_e268 + _e269));
let _e273 = select(_e112, _e271, (_e271 < _e112));
let _e278 = global_2.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e279 = (_e258 + _e267);
let _e280 = (_e108 + _e278);
let _e281 = local_4;
let _e283 = local_5;
let _e285 = bitcast<i32>(((2u * _e281) + _e283));
let _e287 = select(_e112, _e285, (_e285 < _e112));
let _e292 = global_2.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e293 = local_4;
let _e295 = local_5;
let _e297 = bitcast<i32>(((3u * _e293) + _e295));
let _e299 = select(_e112, _e297, (_e297 < _e112));
let _e304 = global_2.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e305 = (_e258 + _e292);
let _e306 = (_e108 + _e304);
let _e307 = local_4;
let _e309 = local_5;
let _e311 = bitcast<i32>(((4u * _e307) + _e309));
let _e313 = select(_e112, _e311, (_e311 < _e112));
let _e318 = global_2.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e319 = local_4;
let _e321 = local_5;
let _e323 = bitcast<i32>(((5u * _e319) + _e321));
let _e325 = select(_e112, _e323, (_e323 < _e112));
let _e330 = global_2.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e331 = local_4;
let _e333 = local_5;
let _e335 = bitcast<i32>(((6u * _e331) + _e333));
let _e337 = select(_e112, _e335, (_e335 < _e112));
let _e342 = global_2.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = (1f / select(1e-6f, _e342, (_e342 > 1e-6f)));
let _e348 = local_4;
let _e350 = local_5;
let _e352 = bitcast<i32>(((7u * _e348) + _e350));
let _e354 = select(_e112, _e352, (_e352 < _e112));
let _e359 = global_2.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e360 = local_4;
let _e362 = local_5;
let _e364 = bitcast<i32>(((8u * _e360) + _e362));
let _e366 = select(_e112, _e364, (_e364 < _e112));
let _e371 = global_2.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e372 = local_4;
let _e374 = local_5;
let _e376 = bitcast<i32>(((9u * _e372) + _e374));
let _e378 = select(_e112, _e376, (_e376 < _e112));
let _e383 = global_2.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e385 = local_4;
let _e387 = local_5;
let _e389 = bitcast<i32>(((10u * _e385) + _e387));
let _e391 = select(_e112, _e389, (_e389 < _e112));
let _e396 = global_2.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
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
let _e417 = global_2.member[bitcast<u32>(select(0i, _e412, (_e412 > 0i)))];
let _e418 = local_2;
let _e419 = local_3;
let _e421 = bitcast<i32>((_e418 + _e419));
let _e423 = select(_e112, _e421, (_e421 < _e112));
let _e428 = global_2.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e429 = (_e105 + _e417);
let _e430 = (_e408 + _e428);
let _e431 = local_2;
let _e433 = local_3;
let _e435 = bitcast<i32>(((2u * _e431) + _e433));
let _e437 = select(_e112, _e435, (_e435 < _e112));
let _e442 = global_2.member[bitcast<u32>(select(0i, _e437, (_e437 > 0i)))];
let _e443 = local_2;
let _e445 = local_3;
let _e447 = bitcast<i32>(((3u * _e443) + _e445));
let _e449 = select(_e112, _e447, (_e447 < _e112));
let _e454 = global_2.member[bitcast<u32>(select(0i, _e449, (_e449 > 0i)))];
let _e455 = (_e105 + _e442);
let _e456 = (_e408 + _e454);
let _e457 = local_2;
let _e459 = local_3;
let _e461 = bitcast<i32>(((4u * _e457) + _e459));
let _e463 = select(_e112, _e461, (_e461 < _e112));
let _e468 = global_2.member[bitcast<u32>(select(0i, _e463, (_e463 > 0i)))];
let _e469 = local_2;
let _e471 = local_3;
let _e473 = bitcast<i32>(((5u * _e469) + _e471));
let _e475 = select(_e112, _e473, (_e473 < _e112));
let _e480 = global_2.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e481 = local_2;
let _e483 = local_3;
let _e485 = bitcast<i32>(((6u * _e481) + _e483));
let _e487 = select(_e112, _e485, (_e485 < _e112));
let _e492 = global_2.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e495 = (1f / select(1e-6f, _e492, (_e492 > 1e-6f)));
let _e498 = local_2;
let _e500 = local_3;
let _e502 = bitcast<i32>(((7u * _e498) + _e500));
let _e504 = select(_e112, _e502, (_e502 < _e112));
let _e509 = global_2.member[bitcast<u32>(select(0i, _e504, (_e504 > 0i)))];
let _e510 = local_2;
let _e512 = local_3;
let _e514 = bitcast<i32>(((8u * _e510) + _e512));
let _e516 = select(_e112, _e514, (_e514 < _e112));
let _e521 = global_2.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e522 = local_2;
let _e524 = local_3;
let _e526 = bitcast<i32>(((9u * _e522) + _e524));
let _e528 = select(_e112, _e526, (_e526 < _e112));
let _e533 = global_2.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e535 = local_2;
let _e537 = local_3;
let _e539 = bitcast<i32>(((10u * _e535) + _e537));
let _e541 = select(_e112, _e539, (_e539 < _e112));
let _e546 = global_2.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
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
let _e561 = global_2.member[bitcast<u32>(select(0i, _e556, (_e556 > 0i)))];
let _e562 = local;
let _e563 = local_1;
let _e565 = bitcast<i32>((_e562 + _e563));
let _e567 = select(_e112, _e565, (_e565 < _e112));
let _e572 = global_2.member[bitcast<u32>(select(0i, _e567, (_e567 > 0i)))];
let _e573 = (_e258 + _e561);
let _e574 = (_e408 + _e572);
let _e575 = local;
let _e577 = local_1;
let _e579 = bitcast<i32>(((2u * _e575) + _e577));
let _e581 = select(_e112, _e579, (_e579 < _e112));
let _e586 = global_2.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = local;
let _e589 = local_1;
let _e591 = bitcast<i32>(((3u * _e587) + _e589));
let _e593 = select(_e112, _e591, (_e591 < _e112));
let _e598 = global_2.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e599 = (_e258 + _e586);
let _e600 = (_e408 + _e598);
let _e601 = local;
let _e603 = local_1;
let _e605 = bitcast<i32>(((4u * _e601) + _e603));
let _e607 = select(_e112, _e605, (_e605 < _e112));
let _e612 = global_2.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e613 = local;
let _e615 = local_1;
let _e617 = bitcast<i32>(((5u * _e613) + _e615));
let _e619 = select(_e112, _e617, (_e617 < _e112));
let _e624 = global_2.member[bitcast<u32>(select(0i, _e619, (_e619 > 0i)))];
let _e625 = local;
let _e627 = local_1;
let _e629 = bitcast<i32>(((6u * _e625) + _e627));
let _e631 = select(_e112, _e629, (_e629 < _e112));
let _e636 = global_2.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e639 = (1f / select(1e-6f, _e636, (_e636 > 1e-6f)));
let _e642 = local;
let _e644 = local_1;
let _e646 = bitcast<i32>(((7u * _e642) + _e644));
let _e648 = select(_e112, _e646, (_e646 < _e112));
let _e653 = global_2.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e654 = local;
let _e656 = local_1;
let _e658 = bitcast<i32>(((8u * _e654) + _e656));
let _e660 = select(_e112, _e658, (_e658 < _e112));
let _e665 = global_2.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e666 = local;
let _e668 = local_1;
let _e670 = bitcast<i32>(((9u * _e666) + _e668));
let _e672 = select(_e112, _e670, (_e670 < _e112));
let _e677 = global_2.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e679 = local;
let _e681 = local_1;
let _e683 = bitcast<i32>(((10u * _e679) + _e681));
let _e685 = select(_e112, _e683, (_e683 < _e112));
let _e690 = global_2.member[bitcast<u32>(select(0i, _e685, (_e685 > 0i)))];
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
let _e772 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e774 = select(_e772, _e770, (_e770 < _e772));
let _e780 = global_3.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e781 = (_e770 + 1i);
let _e783 = select(_e772, _e781, (_e781 < _e772));
let _e789 = global_3.member[bitcast<u32>(select(0i, _e783, (_e783 > 0i)))];
let _e790 = (_e770 + 2i);
let _e792 = select(_e772, _e790, (_e790 < _e772));
let _e798 = global_3.member[bitcast<u32>(select(0i, _e792, (_e792 > 0i)))];
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
let _e937 = (_e936 == 0i);
if _e937 {
} else {
let _e938 = bitcast<u32>(_e936);
let _e939 = bitcast<u32>(_e918);
if (_e939 < _e62) {
let _e943 = atomicAdd((&global_4.member[_e939]), _e938);
phi_1838_ = _e943;
} else {
phi_1838_ = 0u;
}
let _e945 = phi_1838_;
let _e952 = (bitcast<u32>((_e936 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e945 + _e938) < _e938)));
if (_e952 == 0u) {
} else {
let _e954 = (_e939 + 1u);
if (_e954 < _e62) {
let _e958 = atomicAdd((&global_4.member[_e954]), _e952);
}
}
}
if _e937 {
} else {
let _e960 = bitcast<u32>(_e936);
let _e961 = bitcast<u32>((_e918 + 2i));
if (_e961 < _e62) {
let _e965 = atomicAdd((&global_4.member[_e961]), _e960);
phi_1899_ = _e965;
} else {
phi_1899_ = 0u;
}
let _e967 = phi_1899_;
let _e974 = (bitcast<u32>((_e936 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e967 + _e960) < _e960)));
if (_e974 == 0u) {
} else {
let _e976 = (_e961 + 1u);
if (_e976 < _e62) {
let _e980 = atomicAdd((&global_4.member[_e976]), _e974);
}
}
}
if _e937 {
} else {
let _e982 = bitcast<u32>(_e936);
let _e983 = bitcast<u32>((_e918 + 4i));
if (_e983 < _e62) {
let _e987 = atomicAdd((&global_4.member[_e983]), _e982);
phi_1960_ = _e987;
} else {
phi_1960_ = 0u;
}
let _e989 = phi_1960_;
let _e996 = (bitcast<u32>((_e936 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e989 + _e982) < _e982)));
if (_e996 == 0u) {
} else {
let _e998 = (_e983 + 1u);
if (_e998 < _e62) {
let _e1002 = atomicAdd((&global_4.member[_e998]), _e996);
}
}
}
let _e1004 = ((((_e799 + _e799) + _e799) * (1f / 3f)) * _e914);
let _e1007 = (((_e1004 * ((_e780 * _e802) - _e757)) * 8388608f) + 0.5f);
let _e1009 = select(-1073741800f, _e1007, (_e1007 > -1073741800f));
let _e1011 = select(1073741800f, _e1009, (_e1009 < 1073741800f));
let _e1018 = select(0i, select(select(i32(_e1011), i32(-2147483648), (_e1011 < -2147483600f)), 2147483647i, (_e1011 > 2147483500f)), (_e1011 == _e1011));
let _e1022 = (_e1018 - select(0i, 1i, (_e1011 < f32(_e1018))));
if (_e1022 == 0i) {
} else {
let _e1024 = bitcast<u32>(_e1022);
let _e1025 = bitcast<u32>((_e918 + 6i));
if (_e1025 < _e62) {
let _e1029 = atomicAdd((&global_4.member[_e1025]), _e1024);
phi_2021_ = _e1029;
} else {
phi_2021_ = 0u;
}
let _e1031 = phi_2021_;
let _e1038 = (bitcast<u32>((_e1022 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1031 + _e1024) < _e1024)));
if (_e1038 == 0u) {
} else {
let _e1040 = (_e1025 + 1u);
if (_e1040 < _e62) {
let _e1044 = atomicAdd((&global_4.member[_e1040]), _e1038);
}
}
}
let _e1048 = (((_e1004 * ((_e789 * _e802) - _e758)) * 8388608f) + 0.5f);
let _e1050 = select(-1073741800f, _e1048, (_e1048 > -1073741800f));
let _e1052 = select(1073741800f, _e1050, (_e1050 < 1073741800f));
let _e1059 = select(0i, select(select(i32(_e1052), i32(-2147483648), (_e1052 < -2147483600f)), 2147483647i, (_e1052 > 2147483500f)), (_e1052 == _e1052));
let _e1063 = (_e1059 - select(0i, 1i, (_e1052 < f32(_e1059))));
if (_e1063 == 0i) {
} else {
let _e1065 = bitcast<u32>(_e1063);
let _e1066 = bitcast<u32>((_e918 + 8i));
if (_e1066 < _e62) {
let _e1070 = atomicAdd((&global_4.member[_e1066]), _e1065);
phi_2083_ = _e1070;
} else {
phi_2083_ = 0u;
}
let _e1072 = phi_2083_;
let _e1079 = (bitcast<u32>((_e1063 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1072 + _e1065) < _e1065)));
if (_e1079 == 0u) {
} else {
let _e1081 = (_e1066 + 1u);
if (_e1081 < _e62) {
let _e1085 = atomicAdd((&global_4.member[_e1081]), _e1079);
}
}
}
}
phi_1758_ = (_e901 + 1i);
} else {
phi_1758_ = i32();
}
let _e1088 = phi_1758_;
continue;
continuing {
phi_1757_ = _e1088;
break if !(_e902);
}
}
phi_1726_ = (_e887 + 1i);
} else {
phi_1726_ = i32();
}
let _e1092 = phi_1726_;
continue;
continuing {
phi_1725_ = _e1092;
break if !(_e888);
}
}
}
let _e1104 = (((select(0f, 1f, !(_e249)) + select(0f, 1f, !(_e397))) + select(0f, 1f, !(_e547))) + select(0f, 1f, !(_e691)));
if (_e738 && (_e1104 > 0f)) {
if _e249 {
phi_2135_ = _e551;
} else {
phi_2135_ = _e253;
}
let _e1108 = phi_2135_;
if _e397 {
phi_2139_ = _e695;
} else {
phi_2139_ = _e401;
}
let _e1110 = phi_2139_;
if _e1108.member_4 {
phi_2144_ = _e1110;
} else {
phi_2144_ = _e1108;
}
let _e1113 = phi_2144_;
if _e397 {
phi_2148_ = _e1113;
} else {
phi_2148_ = _e401;
}
let _e1115 = phi_2148_;
if _e249 {
phi_2152_ = _e1115;
} else {
phi_2152_ = _e253;
}
let _e1117 = phi_2152_;
if _e1110.member_4 {
phi_2157_ = _e1108;
} else {
phi_2157_ = _e1110;
}
let _e1120 = phi_2157_;
if _e1117.member_4 {
phi_2162_ = _e1120;
} else {
phi_2162_ = _e1117;
}
let _e1123 = phi_2162_;
if _e397 {
phi_2166_ = _e1123;
} else {
phi_2166_ = _e401;
}
let _e1125 = phi_2166_;
if _e1108.member_4 {
phi_2171_ = _e1110;
} else {
phi_2171_ = _e1108;
}
let _e1127 = phi_2171_;
if _e691 {
phi_2175_ = _e1127;
} else {
phi_2175_ = _e695;
}
let _e1129 = phi_2175_;
if _e547 {
phi_2179_ = _e1129;
} else {
phi_2179_ = _e551;
}
let _e1131 = phi_2179_;
if _e1110.member_4 {
phi_2184_ = _e1108;
} else {
phi_2184_ = _e1110;
}
let _e1133 = phi_2184_;
if _e1131.member_4 {
phi_2189_ = _e1133;
} else {
phi_2189_ = _e1131;
}
let _e1136 = phi_2189_;
if _e691 {
phi_2193_ = _e1136;
} else {
phi_2193_ = _e695;
}
let _e1138 = phi_2193_;
let _e1147 = (_e1125.member.x - _e1117.member.x);
let _e1148 = (_e1125.member.y - _e1117.member.y);
let _e1151 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
let _e1154 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
let _e1165 = (_e1138.member.x - _e1131.member.x);
let _e1166 = (_e1138.member.y - _e1131.member.y);
let _e1169 = bitcast<f32>((bitcast<u32>(_e1165) & 2147483647u));
let _e1172 = bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u));
let _e1174 = select(_e1172, _e1169, (_e1169 > _e1172));
let _e1177 = (select(_e1174, _e1156, (_e1156 > _e1174)) - 1e-3f);
let _e1178 = (64f - 1f);
let _e1180 = select(0f, _e1177, (_e1177 > 0f));
let _e1182 = select(_e1178, _e1180, (_e1180 < _e1178));
let _e1189 = select(0i, select(select(i32(_e1182), i32(-2147483648), (_e1182 < -2147483600f)), 2147483647i, (_e1182 > 2147483500f)), (_e1182 == _e1182));
let _e1195 = f32((1i + (_e1189 - select(0i, 1i, (_e1182 < f32(_e1189))))));
let _e1196 = (_e1131.member.x - _e1117.member.x);
let _e1197 = (_e1131.member.y - _e1117.member.y);
let _e1200 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
let _e1203 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
let _e1205 = select(_e1203, _e1200, (_e1200 > _e1203));
let _e1206 = (_e1138.member.x - _e1125.member.x);
let _e1207 = (_e1138.member.y - _e1125.member.y);
let _e1210 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
let _e1213 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
let _e1218 = (select(_e1215, _e1205, (_e1205 > _e1215)) - 1e-3f);
let _e1220 = select(0f, _e1218, (_e1218 > 0f));
let _e1222 = select(_e1178, _e1220, (_e1220 < _e1178));
let _e1229 = select(0i, select(select(i32(_e1222), i32(-2147483648), (_e1222 < -2147483600f)), 2147483647i, (_e1222 > 2147483500f)), (_e1222 == _e1222));
let _e1235 = f32((1i + (_e1229 - select(0i, 1i, (_e1222 < f32(_e1229))))));
let _e1237 = (64f / (_e1195 * _e1235));
let _e1239 = select(_e1237, 1f, (1f < _e1237));
let _e1242 = sqrt(select(0f, _e1239, (_e1239 > 0f)));
let _e1243 = (_e1195 * _e1242);
let _e1245 = select(1f, _e1243, (_e1243 > 1f));
let _e1247 = select(64f, _e1245, (_e1245 < 64f));
let _e1254 = select(0i, select(select(i32(_e1247), i32(-2147483648), (_e1247 < -2147483600f)), 2147483647i, (_e1247 > 2147483500f)), (_e1247 == _e1247));
let _e1258 = (_e1254 - select(0i, 1i, (_e1247 < f32(_e1254))));
let _e1259 = (_e1235 * _e1242);
let _e1261 = select(1f, _e1259, (_e1259 > 1f));
let _e1263 = select(64f, _e1261, (_e1261 < 64f));
let _e1270 = select(0i, select(select(i32(_e1263), i32(-2147483648), (_e1263 < -2147483600f)), 2147483647i, (_e1263 > 2147483500f)), (_e1263 == _e1263));
let _e1274 = (_e1270 - select(0i, 1i, (_e1263 < f32(_e1270))));
let _e1276 = (1f / f32(_e1258));
let _e1278 = (1f / f32(_e1274));
let _e1281 = ((_e1276 * _e1278) * (_e1104 * 0.25f));
phi_2395_ = 0i;
loop {
let _e1283 = phi_2395_;
let _e1284 = (_e1283 < _e1274);
if _e1284 {
let _e1287 = ((f32(_e1283) + 0.5f) * _e1278);
phi_2426_ = 0i;
loop {
let _e1295 = phi_2426_;
let _e1296 = (_e1295 < _e1258);
if _e1296 {
let _e1299 = ((f32(_e1295) + 0.5f) * _e1276);
let _e1314 = ((bitcast<f32>((bitcast<u32>((_e1147 + ((_e1165 - _e1147) * _e1287))) & 2147483647u)) * _e1276) + (bitcast<f32>((bitcast<u32>((_e1196 + ((_e1206 - _e1196) * _e1299))) & 2147483647u)) * _e1278));
let _e1323 = ((bitcast<f32>((bitcast<u32>((_e1148 + ((_e1166 - _e1148) * _e1287))) & 2147483647u)) * _e1276) + (bitcast<f32>((bitcast<u32>((_e1197 + ((_e1207 - _e1197) * _e1299))) & 2147483647u)) * _e1278));
let _e1325 = (_e1117.member.x + (_e1147 * _e1299));
let _e1332 = (_e1117.member.y + (_e1148 * _e1299));
let _e1348 = (_e1117.member_3.x + ((_e1125.member_3.x - _e1117.member_3.x) * _e1299));
let _e1355 = ((_e1348 + (((_e1131.member_3.x + ((_e1138.member_3.x - _e1131.member_3.x) * _e1299)) - _e1348) * _e1287)) * _e1281);
let _e1366 = (_e1117.member_3.y + ((_e1125.member_3.y - _e1117.member_3.y) * _e1299));
let _e1373 = ((_e1366 + (((_e1131.member_3.y + ((_e1138.member_3.y - _e1131.member_3.y) * _e1299)) - _e1366) * _e1287)) * _e1281);
let _e1384 = (_e1117.member_3.z + ((_e1125.member_3.z - _e1117.member_3.z) * _e1299));
let _e1391 = ((_e1384 + (((_e1131.member_3.z + ((_e1138.member_3.z - _e1131.member_3.z) * _e1299)) - _e1384) * _e1287)) * _e1281);
let _e1402 = (_e1117.member_2.x + ((_e1125.member_2.x - _e1117.member_2.x) * _e1299));
let _e1419 = (_e1117.member_2.y + ((_e1125.member_2.y - _e1117.member_2.y) * _e1299));
let _e1428 = bitcast<i32>(_e92);
let _e1431 = select(9.765625e-4f, _e1314, (_e1314 > 9.765625e-4f));
let _e1433 = select(4f, _e1431, (_e1431 < 4f));
let _e1435 = select(9.765625e-4f, _e1323, (_e1323 > 9.765625e-4f));
let _e1437 = select(4f, _e1435, (_e1435 < 4f));
let _e1439 = ((_e1325 + (((_e1131.member.x + (_e1165 * _e1299)) - _e1325) * _e1287)) - (0.5f * _e1433));
let _e1441 = ((_e1332 + (((_e1131.member.y + (_e1166 * _e1299)) - _e1332) * _e1287)) - (0.5f * _e1437));
let _e1446 = (_e1439 + 0.5f);
let _e1448 = select(0f, _e1446, (_e1446 > 0f));
let _e1450 = select(65536f, _e1448, (_e1448 < 65536f));
let _e1457 = select(0i, select(select(i32(_e1450), i32(-2147483648), (_e1450 < -2147483600f)), 2147483647i, (_e1450 > 2147483500f)), (_e1450 == _e1450));
let _e1462 = (_e1439 + _e1433);
let _e1463 = (_e1462 + 0.5f);
let _e1465 = f32((_e1428 - 1i));
let _e1467 = select(-1f, _e1463, (_e1463 > -1f));
let _e1469 = select(_e1465, _e1467, (_e1467 < _e1465));
let _e1476 = select(0i, select(select(i32(_e1469), i32(-2147483648), (_e1469 < -2147483600f)), 2147483647i, (_e1469 > 2147483500f)), (_e1469 == _e1469));
let _e1481 = (_e1441 + _e1437);
let _e1482 = (_e1481 + 0.5f);
let _e1484 = f32((bitcast<i32>(_e79) - 1i));
let _e1486 = select(-1f, _e1482, (_e1482 > -1f));
let _e1488 = select(_e1484, _e1486, (_e1486 < _e1484));
let _e1495 = select(0i, select(select(i32(_e1488), i32(-2147483648), (_e1488 < -2147483600f)), 2147483647i, (_e1488 > 2147483500f)), (_e1488 == _e1488));
let _e1500 = (_e1441 + 0.5f);
let _e1502 = select(0f, _e1500, (_e1500 > 0f));
let _e1504 = select(65536f, _e1502, (_e1502 < 65536f));
let _e1511 = select(0i, select(select(i32(_e1504), i32(-2147483648), (_e1504 < -2147483600f)), 2147483647i, (_e1504 > 2147483500f)), (_e1504 == _e1504));
phi_2709_ = (_e1511 - select(0i, 1i, (_e1504 < f32(_e1511))));
loop {
let _e1517 = phi_2709_;
let _e1518 = (_e1517 <= (_e1495 - select(0i, 1i, (_e1488 < f32(_e1495)))));
if _e1518 {
let _e1519 = f32(_e1517);
let _e1520 = (_e1519 - 0.5f);
let _e1523 = (_e1519 + 0.5f);
let _e1526 = (select(_e1523, _e1481, (_e1481 < _e1523)) - select(_e1520, _e1441, (_e1441 > _e1520)));
phi_2741_ = (_e1457 - select(0i, 1i, (_e1450 < f32(_e1457))));
loop {
let _e1531 = phi_2741_;
let _e1532 = (_e1531 <= (_e1476 - select(0i, 1i, (_e1469 < f32(_e1476)))));
if _e1532 {
let _e1533 = f32(_e1531);
let _e1534 = (_e1533 - 0.5f);
let _e1537 = (_e1533 + 0.5f);
let _e1540 = (select(_e1537, _e1462, (_e1462 < _e1537)) - select(_e1534, _e1439, (_e1439 > _e1534)));
let _e1544 = ((select(0f, _e1540, (_e1540 > 0f)) / _e1433) * (select(0f, _e1526, (_e1526 > 0f)) / _e1437));
if (_e1544 > 0f) {
let _e1548 = (((_e1517 * _e1428) + _e1531) * 10i);
let _e1551 = (((_e1355 * _e1544) * 16777216f) + 0.5f);
let _e1553 = select(-1073741800f, _e1551, (_e1551 > -1073741800f));
let _e1555 = select(1073741800f, _e1553, (_e1553 < 1073741800f));
let _e1562 = select(0i, select(select(i32(_e1555), i32(-2147483648), (_e1555 < -2147483600f)), 2147483647i, (_e1555 > 2147483500f)), (_e1555 == _e1555));
let _e1566 = (_e1562 - select(0i, 1i, (_e1555 < f32(_e1562))));
if (_e1566 == 0i) {
} else {
let _e1568 = bitcast<u32>(_e1566);
let _e1569 = bitcast<u32>(_e1548);
if (_e1569 < _e62) {
let _e1573 = atomicAdd((&global_4.member[_e1569]), _e1568);
phi_2822_ = _e1573;
} else {
phi_2822_ = 0u;
}
let _e1575 = phi_2822_;
let _e1582 = (bitcast<u32>((_e1566 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1575 + _e1568) < _e1568)));
if (_e1582 == 0u) {
} else {
let _e1584 = (_e1569 + 1u);
if (_e1584 < _e62) {
let _e1588 = atomicAdd((&global_4.member[_e1584]), _e1582);
}
}
}
let _e1592 = (((_e1373 * _e1544) * 16777216f) + 0.5f);
let _e1594 = select(-1073741800f, _e1592, (_e1592 > -1073741800f));
let _e1596 = select(1073741800f, _e1594, (_e1594 < 1073741800f));
let _e1603 = select(0i, select(select(i32(_e1596), i32(-2147483648), (_e1596 < -2147483600f)), 2147483647i, (_e1596 > 2147483500f)), (_e1596 == _e1596));
let _e1607 = (_e1603 - select(0i, 1i, (_e1596 < f32(_e1603))));
if (_e1607 == 0i) {
} else {
let _e1609 = bitcast<u32>(_e1607);
let _e1610 = bitcast<u32>((_e1548 + 2i));
if (_e1610 < _e62) {
let _e1614 = atomicAdd((&global_4.member[_e1610]), _e1609);
phi_2883_ = _e1614;
} else {
phi_2883_ = 0u;
}
let _e1616 = phi_2883_;
let _e1623 = (bitcast<u32>((_e1607 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1616 + _e1609) < _e1609)));
if (_e1623 == 0u) {
} else {
let _e1625 = (_e1610 + 1u);
if (_e1625 < _e62) {
let _e1629 = atomicAdd((&global_4.member[_e1625]), _e1623);
}
}
}
let _e1633 = (((_e1391 * _e1544) * 16777216f) + 0.5f);
let _e1635 = select(-1073741800f, _e1633, (_e1633 > -1073741800f));
let _e1637 = select(1073741800f, _e1635, (_e1635 < 1073741800f));
let _e1644 = select(0i, select(select(i32(_e1637), i32(-2147483648), (_e1637 < -2147483600f)), 2147483647i, (_e1637 > 2147483500f)), (_e1637 == _e1637));
let _e1648 = (_e1644 - select(0i, 1i, (_e1637 < f32(_e1644))));
if (_e1648 == 0i) {
} else {
let _e1650 = bitcast<u32>(_e1648);
let _e1651 = bitcast<u32>((_e1548 + 4i));
if (_e1651 < _e62) {
let _e1655 = atomicAdd((&global_4.member[_e1651]), _e1650);
phi_2944_ = _e1655;
} else {
phi_2944_ = 0u;
}
let _e1657 = phi_2944_;
let _e1664 = (bitcast<u32>((_e1648 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1657 + _e1650) < _e1650)));
if (_e1664 == 0u) {
} else {
let _e1666 = (_e1651 + 1u);
if (_e1666 < _e62) {
let _e1670 = atomicAdd((&global_4.member[_e1666]), _e1664);
}
}
}
let _e1672 = ((((_e1355 + _e1373) + _e1391) * (1f / 3f)) * _e1544);
let _e1675 = (((_e1672 * ((_e1402 + (((_e1131.member_2.x + ((_e1138.member_2.x - _e1131.member_2.x) * _e1299)) - _e1402) * _e1287)) - _e757)) * 8388608f) + 0.5f);
let _e1677 = select(-1073741800f, _e1675, (_e1675 > -1073741800f));
let _e1679 = select(1073741800f, _e1677, (_e1677 < 1073741800f));
let _e1686 = select(0i, select(select(i32(_e1679), i32(-2147483648), (_e1679 < -2147483600f)), 2147483647i, (_e1679 > 2147483500f)), (_e1679 == _e1679));
let _e1690 = (_e1686 - select(0i, 1i, (_e1679 < f32(_e1686))));
if (_e1690 == 0i) {
} else {
let _e1692 = bitcast<u32>(_e1690);
let _e1693 = bitcast<u32>((_e1548 + 6i));
if (_e1693 < _e62) {
let _e1697 = atomicAdd((&global_4.member[_e1693]), _e1692);
phi_3005_ = _e1697;
} else {
phi_3005_ = 0u;
}
let _e1699 = phi_3005_;
let _e1706 = (bitcast<u32>((_e1690 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1699 + _e1692) < _e1692)));
if (_e1706 == 0u) {
} else {
let _e1708 = (_e1693 + 1u);
if (_e1708 < _e62) {
let _e1712 = atomicAdd((&global_4.member[_e1708]), _e1706);
}
}
}
let _e1716 = (((_e1672 * ((_e1419 + (((_e1131.member_2.y + ((_e1138.member_2.y - _e1131.member_2.y) * _e1299)) - _e1419) * _e1287)) - _e758)) * 8388608f) + 0.5f);
let _e1718 = select(-1073741800f, _e1716, (_e1716 > -1073741800f));
let _e1720 = select(1073741800f, _e1718, (_e1718 < 1073741800f));
let _e1727 = select(0i, select(select(i32(_e1720), i32(-2147483648), (_e1720 < -2147483600f)), 2147483647i, (_e1720 > 2147483500f)), (_e1720 == _e1720));
let _e1731 = (_e1727 - select(0i, 1i, (_e1720 < f32(_e1727))));
if (_e1731 == 0i) {
} else {
let _e1733 = bitcast<u32>(_e1731);
let _e1734 = bitcast<u32>((_e1548 + 8i));
if (_e1734 < _e62) {
let _e1738 = atomicAdd((&global_4.member[_e1734]), _e1733);
phi_3067_ = _e1738;
} else {
phi_3067_ = 0u;
}
let _e1740 = phi_3067_;
let _e1747 = (bitcast<u32>((_e1731 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1740 + _e1733) < _e1733)));
if (_e1747 == 0u) {
} else {
let _e1749 = (_e1734 + 1u);
if (_e1749 < _e62) {
let _e1753 = atomicAdd((&global_4.member[_e1749]), _e1747);
}
}
}
}
phi_2742_ = (_e1531 + 1i);
} else {
phi_2742_ = i32();
}
let _e1756 = phi_2742_;
continue;
continuing {
phi_2741_ = _e1756;
break if !(_e1532);
}
}
phi_2710_ = (_e1517 + 1i);
} else {
phi_2710_ = i32();
}
let _e1760 = phi_2710_;
continue;
continuing {
phi_2709_ = _e1760;
break if !(_e1518);
}
}
phi_2427_ = (_e1295 + 1i);
} else {
phi_2427_ = i32();
}
let _e1764 = phi_2427_;
continue;
continuing {
phi_2426_ = _e1764;
break if !(_e1296);
}
}
phi_2396_ = (_e1283 + 1i);
} else {
phi_2396_ = i32();
}
let _e1768 = phi_2396_;
continue;
continuing {
phi_2395_ = _e1768;
break if !(_e1284);
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
