struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_3 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_4 {
member: u32,
member_1: u32,
}
struct type_6 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_7 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_8 {
member: type_7,
member_1: f32,
}
struct type_10 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: type_7,
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
struct type_11 {
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
struct type_12 {
member: type_7,
member_1: type_7,
}
struct type_13 {
member: type_4,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_14 {
member: type_7,
member_1: f32,
member_2: f32,
}
struct type_15 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: u32,
member_4: type_4,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_4,
member_18: type_13,
member_19: type_7,
member_20: type_14,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_17 {
member: type_8,
member_1: type_7,
}
struct type_18 {
member: type_17,
member_1: type_17,
}
struct type_19 {
member: type_8,
member_1: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_3,
member_3: type_4,
member_4: type_4,
member_5: u32,
member_6: u32,
member_7: type_6,
member_8: type_10,
member_9: type_10,
member_10: type_11,
member_11: type_12,
member_12: type_15,
member_13: type_6,
member_14: type_16,
member_15: type_18,
member_16: type_19,
member_17: type_19,
member_18: type_19,
member_19: type_19,
member_20: type_7,
member_21: f32,
member_22: f32,
member_23: type_20,
}
struct type_22 {
member: type_21,
}
struct type_24 {
member: array<u32>,
}
struct type_26 {
member: array<f32>,
}
struct type_29 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_32 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_33 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_34 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: f32,
member_5: f32,
member_6: vec3<f32>,
}
struct type_35 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_24;
@group(0) @binding(4)
var<storage> global_3: type_24;
@group(0) @binding(6)
var<storage, read_write> global_4: type_26;
@group(0) @binding(3)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage> global_6: type_26;
fn function_() {
var local: f32;
var local_1: f32;
var local_2: type_29;
var local_3: vec3<f32>;
var local_4: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var local_8: type_29;
var local_9: vec3<f32>;
var local_10: type_29;
var local_11: vec3<f32>;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var local_17: f32;
var local_18: f32;
var local_19: f32;
var local_20: f32;
var local_21: f32;
var local_22: f32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
var local_26: type_29;
var local_27: vec3<f32>;
var phi_902_: bool;
var phi_1082_: bool;
var phi_1085_: bool;
var phi_1269_: bool;
var phi_1592_: u32;
var phi_7267_: type_32;
var phi_8030_: type_33;
var phi_8980_: type_7;
var phi_12708_: type_35;
var phi_14027_: type_34;
var phi_14040_: vec3<f32>;
var phi_14041_: f32;
var phi_16773_: type_34;
var phi_16925_: vec3<f32>;
var phi_16926_: f32;
let _e157 = global;
let _e160 = arrayLength((&global_2.member));
let _e165 = arrayLength((&global_3.member));
let _e167 = arrayLength((&global_6.member));
let _e172 = global_1.member.member_2;
let _e175 = global_1.member.member;
let _e183 = (_e157.x + _e172.member);
let _e185 = (_e157.y + _e172.member_1);
if (_e183 < _e172.member_2) {
if (_e185 < _e172.member_3) {
let _e188 = (_e175.member * _e175.member_1);
let _e190 = ((_e185 * _e175.member) + _e183);
let _e191 = bitcast<i32>(_e190);
let _e193 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e195 = select(_e193, _e191, (_e191 < _e193));
let _e201 = global_4.member[bitcast<u32>(select(0i, _e195, (_e195 > 0i)))];
let _e202 = (_e188 + _e190);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e193, _e203, (_e203 < _e193));
let _e211 = global_4.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((2u * _e188) + _e190);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e193, _e214, (_e214 < _e193));
let _e222 = global_4.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((3u * _e188) + _e190);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e193, _e225, (_e225 < _e193));
let _e233 = global_4.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((4u * _e188) + _e190);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e193, _e236, (_e236 < _e193));
let _e244 = global_4.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = ((5u * _e188) + _e190);
let _e247 = bitcast<i32>(_e246);
let _e249 = select(_e193, _e247, (_e247 < _e193));
let _e255 = global_4.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e257 = ((6u * _e188) + _e190);
let _e258 = bitcast<i32>(_e257);
let _e260 = select(_e193, _e258, (_e258 < _e193));
let _e266 = global_4.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((7u * _e188) + _e190);
let _e269 = bitcast<i32>(_e268);
let _e271 = select(_e193, _e269, (_e269 < _e193));
let _e277 = global_4.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e279 = ((8u * _e188) + _e190);
let _e280 = bitcast<i32>(_e279);
let _e282 = select(_e193, _e280, (_e280 < _e193));
let _e288 = global_4.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e293 = global_1.member.member_10.member;
let _e297 = global_1.member.member_10.member_1;
let _e298 = (_e293 * _e297);
if (_e167 >= (_e298 * 4u)) {
let _e302 = bitcast<i32>((_e185 * _e293));
let _e304 = bitcast<i32>(_e183);
let _e309 = global_6.member[bitcast<u32>((_e302 + _e304))];
let _e315 = global_6.member[bitcast<u32>(((bitcast<i32>(_e298) + _e302) + _e304))];
let _e316 = f32(_e304);
let _e318 = f32(bitcast<i32>(_e185));
let _e324 = global_1.member.member_7.member;
let _e328 = global_1.member.member_10.member_8;
let _e329 = (_e324 - _e328);
let _e333 = global_1.member.member_10.member_2;
let _e337 = global_1.member.member_10.member_6;
let _e344 = global_1.member.member_10.member_4;
let _e346 = ((_e333 + (_e337 * _e329)) + (((_e316 - _e309) + 0.5f) * _e344));
let _e350 = global_1.member.member_10.member_3;
let _e354 = global_1.member.member_10.member_7;
let _e359 = ((_e350 + (_e354 * _e329)) + (((_e318 - _e315) + 0.5f) * _e344));
let _e363 = global_1.member.member_7.member_1;
let _e364 = (_e363 - _e328);
let _e369 = ((_e333 + (_e337 * _e364)) + ((_e316 + 0.5f) * _e344));
let _e374 = ((_e350 + (_e354 * _e364)) + ((_e318 + 0.5f) * _e344));
let _e380 = global_1.member.member_8.member.member;
let _e388 = (((_e380.member * _e380.member) + (_e380.member_1 * _e380.member_1)) + (_e380.member_2 * _e380.member_2));
let _e391 = sqrt(select(0f, _e388, (_e388 > 0f)));
let _e392 = ((1.5f * _e344) * _e391);
let _e396 = (select(1f, _e392, (_e392 < 1f)) + (1f / 64f));
let _e398 = select(_e396, 0.5f, (0.5f > _e396));
let _e402 = global_1.member.member_7.member_2;
let _e405 = (_e402 / select(1e-6f, _e255, (_e255 > 1e-6f)));
let _e409 = (_e369 + (_e233 * _e405));
let _e410 = (_e374 + (_e244 * _e405));
let _e411 = (_e363 + (_e255 * _e405));
let _e415 = global_1.member.member_8.member;
let _e426 = ((((_e415.member.member * _e346) + (_e415.member.member_1 * _e359)) + (_e415.member.member_2 * _e324)) + _e415.member_1);
let _e430 = global_1.member.member_8.member_1;
let _e441 = ((((_e430.member.member * _e346) + (_e430.member.member_1 * _e359)) + (_e430.member.member_2 * _e324)) + _e430.member_1);
let _e445 = global_1.member.member_8.member_2;
let _e456 = ((((_e445.member.member * _e346) + (_e445.member.member_1 * _e359)) + (_e445.member.member_2 * _e324)) + _e445.member_1);
let _e462 = ((((_e415.member.member * _e369) + (_e415.member.member_1 * _e374)) + (_e415.member.member_2 * _e363)) + _e415.member_1);
let _e468 = ((((_e430.member.member * _e369) + (_e430.member.member_1 * _e374)) + (_e430.member.member_2 * _e363)) + _e430.member_1);
let _e474 = ((((_e445.member.member * _e369) + (_e445.member.member_1 * _e374)) + (_e445.member.member_2 * _e363)) + _e445.member_1);
let _e480 = global_1.member.member_8.member_3.member;
let _e481 = (_e480 - 1f);
let _e490 = global_1.member.member_8.member_3.member_1;
let _e491 = (_e490 - 1f);
let _e500 = global_1.member.member_8.member_3.member_2;
let _e501 = (_e500 - 1f);
let _e515 = (((((((_e426 >= 0f) && (_e426 <= _e481)) && (_e441 >= 0f)) && (_e441 <= _e491)) && (_e456 >= 0f)) && (_e456 <= _e501)) && ((((((_e462 >= 0f) && (_e462 <= _e481)) && (_e468 >= 0f)) && (_e468 <= _e491)) && (_e474 >= 0f)) && (_e474 <= _e501)));
let _e524 = ((((_e175.member_2 == 1u) || (_e175.member_2 == 5u)) || (_e175.member_2 == 6u)) || ((_e175.member_2 == 2u) || (_e175.member_2 == 7u)));
if _e524 {
let _e525 = (_e398 - 0.5f);
let _e526 = (_e398 + 0.5f);
let _e528 = (_e480 - _e526);
let _e532 = (_e490 - _e526);
let _e537 = (_e500 - _e526);
let _e540 = ((((_e426 >= _e525) && (_e426 <= _e528)) && ((_e441 >= _e525) && (_e441 <= _e532))) && ((_e456 >= _e525) && (_e456 <= _e537)));
let _e543 = global_1.member.member_1;
let _e545 = ((_e543 & 16u) == 0u);
if _e545 {
phi_902_ = _e540;
} else {
let _e550 = global_1.member.member_16.member;
let _e562 = -((_e398 / _e391));
let _e567 = global_1.member.member_16.member_1;
let _e573 = global_1.member.member_17.member;
let _e589 = global_1.member.member_17.member_1;
let _e596 = global_1.member.member_18.member;
let _e612 = global_1.member.member_18.member_1;
let _e619 = global_1.member.member_19.member;
let _e635 = global_1.member.member_19.member_1;
phi_902_ = (_e540 && (((((((((_e550.member.member * _e346) + (_e550.member.member_1 * _e359)) + (_e550.member.member_2 * _e324)) + _e550.member_1) <= _e562) || (_e567 == 0u)) && ((((((_e573.member.member * _e346) + (_e573.member.member_1 * _e359)) + (_e573.member.member_2 * _e324)) + _e573.member_1) <= _e562) || (_e589 == 0u))) && ((((((_e596.member.member * _e346) + (_e596.member.member_1 * _e359)) + (_e596.member.member_2 * _e324)) + _e596.member_1) <= _e562) || (_e612 == 0u))) && ((((((_e619.member.member * _e346) + (_e619.member.member_1 * _e359)) + (_e619.member.member_2 * _e324)) + _e619.member_1) <= _e562) || (_e635 == 0u))));
}
let _e641 = phi_902_;
let _e645 = (_e369 + (_e369 - _e346));
let _e646 = (_e374 + (_e374 - _e359));
let _e647 = (_e363 + (_e363 - _e324));
let _e653 = ((((_e415.member.member * _e645) + (_e415.member.member_1 * _e646)) + (_e415.member.member_2 * _e647)) + _e415.member_1);
let _e659 = ((((_e430.member.member * _e645) + (_e430.member.member_1 * _e646)) + (_e430.member.member_2 * _e647)) + _e430.member_1);
let _e665 = ((((_e445.member.member * _e645) + (_e445.member.member_1 * _e646)) + (_e445.member.member_2 * _e647)) + _e445.member_1);
let _e676 = ((((_e653 >= _e525) && (_e653 <= _e528)) && ((_e659 >= _e525) && (_e659 <= _e532))) && ((_e665 >= _e525) && (_e665 <= _e537)));
if _e545 {
phi_1082_ = _e676;
} else {
let _e681 = global_1.member.member_16.member;
let _e693 = -((_e398 / _e391));
let _e698 = global_1.member.member_16.member_1;
let _e704 = global_1.member.member_17.member;
let _e720 = global_1.member.member_17.member_1;
let _e727 = global_1.member.member_18.member;
let _e743 = global_1.member.member_18.member_1;
let _e750 = global_1.member.member_19.member;
let _e766 = global_1.member.member_19.member_1;
phi_1082_ = (_e676 && (((((((((_e681.member.member * _e645) + (_e681.member.member_1 * _e646)) + (_e681.member.member_2 * _e647)) + _e681.member_1) <= _e693) || (_e698 == 0u)) && ((((((_e704.member.member * _e645) + (_e704.member.member_1 * _e646)) + (_e704.member.member_2 * _e647)) + _e704.member_1) <= _e693) || (_e720 == 0u))) && ((((((_e727.member.member * _e645) + (_e727.member.member_1 * _e646)) + (_e727.member.member_2 * _e647)) + _e727.member_1) <= _e693) || (_e743 == 0u))) && ((((((_e750.member.member * _e645) + (_e750.member.member_1 * _e646)) + (_e750.member.member_2 * _e647)) + _e750.member_1) <= _e693) || (_e766 == 0u))));
}
let _e772 = phi_1082_;
phi_1085_ = (_e515 && (_e641 && _e772));
} else {
phi_1085_ = _e515;
}
let _e776 = phi_1085_;
let _e783 = ((((_e415.member.member * _e409) + (_e415.member.member_1 * _e410)) + (_e415.member.member_2 * _e411)) + _e415.member_1);
let _e789 = ((((_e430.member.member * _e409) + (_e430.member.member_1 * _e410)) + (_e430.member.member_2 * _e411)) + _e430.member_1);
let _e795 = ((((_e445.member.member * _e409) + (_e445.member.member_1 * _e410)) + (_e445.member.member_2 * _e411)) + _e445.member_1);
let _e796 = (_e398 - 0.5f);
let _e797 = (_e398 + 0.5f);
let _e811 = ((((_e783 >= _e796) && (_e783 <= (_e480 - _e797))) && ((_e789 >= _e796) && (_e789 <= (_e490 - _e797)))) && ((_e795 >= _e796) && (_e795 <= (_e500 - _e797))));
let _e814 = global_1.member.member_1;
if ((_e814 & 16u) == 0u) {
phi_1269_ = _e811;
} else {
let _e821 = global_1.member.member_16.member;
let _e833 = -((_e398 / _e391));
let _e838 = global_1.member.member_16.member_1;
let _e844 = global_1.member.member_17.member;
let _e860 = global_1.member.member_17.member_1;
let _e867 = global_1.member.member_18.member;
let _e883 = global_1.member.member_18.member_1;
let _e890 = global_1.member.member_19.member;
let _e906 = global_1.member.member_19.member_1;
phi_1269_ = (_e811 && (((((((((_e821.member.member * _e409) + (_e821.member.member_1 * _e410)) + (_e821.member.member_2 * _e411)) + _e821.member_1) <= _e833) || (_e838 == 0u)) && ((((((_e844.member.member * _e409) + (_e844.member.member_1 * _e410)) + (_e844.member.member_2 * _e411)) + _e844.member_1) <= _e833) || (_e860 == 0u))) && ((((((_e867.member.member * _e409) + (_e867.member.member_1 * _e410)) + (_e867.member.member_2 * _e411)) + _e867.member_1) <= _e833) || (_e883 == 0u))) && ((((((_e890.member.member * _e409) + (_e890.member.member_1 * _e410)) + (_e890.member.member_2 * _e411)) + _e890.member_1) <= _e833) || (_e906 == 0u))));
}
let _e912 = phi_1269_;
let _e919 = global_1.member.member_8.member_4;
let _e920 = (_e480 - 0.5f);
let _e922 = select(-0.5f, _e462, (_e462 > -0.5f));
let _e924 = select(_e920, _e922, (_e922 < _e920));
let _e925 = (_e490 - 0.5f);
let _e927 = select(-0.5f, _e468, (_e468 > -0.5f));
let _e929 = select(_e925, _e927, (_e927 < _e925));
let _e930 = (_e500 - 0.5f);
let _e932 = select(-0.5f, _e474, (_e474 > -0.5f));
let _e934 = select(_e930, _e932, (_e932 < _e930));
let _e940 = bitcast<f32>((bitcast<u32>((_e462 - _e426)) & 2147483647u));
let _e943 = bitcast<f32>((bitcast<u32>((_e468 - _e441)) & 2147483647u));
let _e945 = select(_e943, _e940, (_e940 > _e943));
let _e948 = bitcast<f32>((bitcast<u32>((_e474 - _e456)) & 2147483647u));
let _e957 = bitcast<f32>((bitcast<u32>((_e462 - _e924)) & 2147483647u));
let _e960 = bitcast<f32>((bitcast<u32>((_e468 - _e929)) & 2147483647u));
let _e962 = select(_e960, _e957, (_e957 > _e960));
let _e965 = bitcast<f32>((bitcast<u32>((_e474 - _e934)) & 2147483647u));
let _e969 = (_e924 + 0.5f);
let _e971 = select(0f, _e969, (_e969 > 0f));
let _e973 = select(_e481, _e971, (_e971 < _e481));
let _e980 = select(0i, select(select(i32(_e973), i32(-2147483648), (_e973 < -2147483600f)), 2147483647i, (_e973 > 2147483500f)), (_e973 == _e973));
let _e988 = global_1.member.member_8.member_12;
let _e989 = (_e988 & 31u);
let _e992 = (_e929 + 0.5f);
let _e994 = select(0f, _e992, (_e992 > 0f));
let _e996 = select(_e491, _e994, (_e994 < _e491));
let _e1003 = select(0i, select(select(i32(_e996), i32(-2147483648), (_e996 < -2147483600f)), 2147483647i, (_e996 > 2147483500f)), (_e996 == _e996));
let _e1010 = (_e934 + 0.5f);
let _e1012 = select(0f, _e1010, (_e1010 > 0f));
let _e1014 = select(_e501, _e1012, (_e1012 < _e501));
let _e1021 = select(0i, select(select(i32(_e1014), i32(-2147483648), (_e1014 < -2147483600f)), 2147483647i, (_e1014 > 2147483500f)), (_e1014 == _e1014));
let _e1032 = global_1.member.member_8.member_9.member;
let _e1038 = global_1.member.member_8.member_9.member_1;
let _e1043 = global_1.member.member_8.member_10;
let _e1049 = ((bitcast<i32>(_e1043) + ((_e980 - select(0i, 1i, (_e973 < f32(_e980)))) >> bitcast<u32>(_e989))) + (bitcast<i32>(_e1032) * (((_e1003 - select(0i, 1i, (_e996 < f32(_e1003)))) >> bitcast<u32>(_e989)) + (bitcast<i32>(_e1038) * ((_e1021 - select(0i, 1i, (_e1014 < f32(_e1021)))) >> bitcast<u32>(_e989))))));
let _e1051 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1053 = select(_e1051, _e1049, (_e1049 < _e1051));
let _e1059 = global_5.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
phi_1592_ = select(select(7u, 3u, (_e776 && (!(_e524) || _e912))), 1u, (((_e814 & 64u) != 0u) || ((((select(_e948, _e945, (_e945 > _e948)) <= _e919) && ((select(_e965, _e962, (_e962 > _e965)) > _e919) || (_e1059 != 0u))) && true) && ((_e814 & 32u) != 0u))));
} else {
phi_1592_ = 7u;
}
let _e1072 = phi_1592_;
if (_e1072 > 1u) {
let _e1077 = bitcast<i32>(((_e185 * _e293) + _e183));
let _e1080 = (bitcast<i32>(_e167) - 1i);
let _e1082 = select(_e1080, _e1077, (_e1077 < _e1080));
let _e1088 = global_6.member[bitcast<u32>(select(0i, _e1082, (_e1082 > 0i)))];
let _e1089 = (bitcast<i32>(_e298) + _e1077);
let _e1091 = select(_e1080, _e1089, (_e1089 < _e1080));
let _e1097 = global_6.member[bitcast<u32>(select(0i, _e1091, (_e1091 > 0i)))];
let _e1099 = f32(bitcast<i32>(_e183));
let _e1101 = f32(bitcast<i32>(_e185));
let _e1107 = global_1.member.member_7.member;
let _e1111 = global_1.member.member_10.member_8;
let _e1112 = (_e1107 - _e1111);
let _e1116 = global_1.member.member_10.member_2;
let _e1120 = global_1.member.member_10.member_6;
let _e1127 = global_1.member.member_10.member_4;
let _e1129 = ((_e1116 + (_e1120 * _e1112)) + (((_e1099 - _e1088) + 0.5f) * _e1127));
let _e1133 = global_1.member.member_10.member_3;
let _e1137 = global_1.member.member_10.member_7;
let _e1142 = ((_e1133 + (_e1137 * _e1112)) + (((_e1101 - _e1097) + 0.5f) * _e1127));
let _e1146 = global_1.member.member_7.member_1;
let _e1147 = (_e1146 - _e1111);
let _e1152 = ((_e1116 + (_e1120 * _e1147)) + ((_e1099 + 0.5f) * _e1127));
let _e1157 = ((_e1133 + (_e1137 * _e1147)) + ((_e1101 + 0.5f) * _e1127));
let _e1161 = global_1.member.member_8.member;
let _e1172 = ((((_e1161.member.member * _e1129) + (_e1161.member.member_1 * _e1142)) + (_e1161.member.member_2 * _e1107)) + _e1161.member_1);
let _e1176 = global_1.member.member_8.member_1;
let _e1187 = ((((_e1176.member.member * _e1129) + (_e1176.member.member_1 * _e1142)) + (_e1176.member.member_2 * _e1107)) + _e1176.member_1);
let _e1191 = global_1.member.member_8.member_2;
let _e1202 = ((((_e1191.member.member * _e1129) + (_e1191.member.member_1 * _e1142)) + (_e1191.member.member_2 * _e1107)) + _e1191.member_1);
let _e1208 = ((((_e1161.member.member * _e1152) + (_e1161.member.member_1 * _e1157)) + (_e1161.member.member_2 * _e1146)) + _e1161.member_1);
let _e1214 = ((((_e1176.member.member * _e1152) + (_e1176.member.member_1 * _e1157)) + (_e1176.member.member_2 * _e1146)) + _e1176.member_1);
let _e1220 = ((((_e1191.member.member * _e1152) + (_e1191.member.member_1 * _e1157)) + (_e1191.member.member_2 * _e1146)) + _e1191.member_1);
let _e1222 = (_e175.member_2 == 5u);
let _e1228 = ((_e175.member_2 == 2u) || (_e175.member_2 == 7u));
let _e1229 = ((((_e175.member_2 == 1u) || _e1222) || (_e175.member_2 == 6u)) || _e1228);
if _e1229 {
let _e1234 = global_1.member.member_8.member_3.member;
let _e1235 = (_e1234 - 0.5f);
let _e1237 = select(-0.5f, _e1208, (_e1208 > -0.5f));
let _e1239 = select(_e1235, _e1237, (_e1237 < _e1235));
let _e1244 = global_1.member.member_8.member_3.member_1;
let _e1245 = (_e1244 - 0.5f);
let _e1247 = select(-0.5f, _e1214, (_e1214 > -0.5f));
let _e1249 = select(_e1245, _e1247, (_e1247 < _e1245));
let _e1254 = global_1.member.member_8.member_3.member_2;
let _e1255 = (_e1254 - 0.5f);
let _e1257 = select(-0.5f, _e1220, (_e1220 > -0.5f));
let _e1259 = select(_e1255, _e1257, (_e1257 < _e1255));
let _e1261 = select(-1f, _e1239, (_e1239 > -1f));
let _e1263 = select(_e1234, _e1261, (_e1261 < _e1234));
let _e1270 = select(0i, select(select(i32(_e1263), i32(-2147483648), (_e1263 < -2147483600f)), 2147483647i, (_e1263 > 2147483500f)), (_e1263 == _e1263));
let _e1274 = (_e1270 - select(0i, 1i, (_e1263 < f32(_e1270))));
let _e1276 = select(-1f, _e1249, (_e1249 > -1f));
let _e1278 = select(_e1244, _e1276, (_e1276 < _e1244));
let _e1285 = select(0i, select(select(i32(_e1278), i32(-2147483648), (_e1278 < -2147483600f)), 2147483647i, (_e1278 > 2147483500f)), (_e1278 == _e1278));
let _e1289 = (_e1285 - select(0i, 1i, (_e1278 < f32(_e1285))));
let _e1291 = select(-1f, _e1259, (_e1259 > -1f));
let _e1293 = select(_e1254, _e1291, (_e1291 < _e1254));
let _e1300 = select(0i, select(select(i32(_e1293), i32(-2147483648), (_e1293 < -2147483600f)), 2147483647i, (_e1293 > 2147483500f)), (_e1293 == _e1293));
let _e1304 = (_e1300 - select(0i, 1i, (_e1293 < f32(_e1300))));
let _e1308 = global_1.member.member_8.member_7;
let _e1312 = global_1.member.member_8.member_8;
let _e1320 = (select(0i, select(select(i32(_e1244), i32(-2147483648), (_e1244 < -2147483600f)), 2147483647i, (_e1244 > 2147483500f)), (_e1244 == _e1244)) - 1i);
let _e1321 = (_e1289 - 1i);
let _e1326 = (_e1289 + 1i);
let _e1329 = (_e1289 + 2i);
let _e1339 = (select(0i, select(select(i32(_e1254), i32(-2147483648), (_e1254 < -2147483600f)), 2147483647i, (_e1254 > 2147483500f)), (_e1254 == _e1254)) - 1i);
let _e1340 = (_e1304 - 1i);
let _e1345 = (_e1304 + 1i);
let _e1348 = (_e1304 + 2i);
let _e1357 = select(0i, select(select(i32(_e1234), i32(-2147483648), (_e1234 < -2147483600f)), 2147483647i, (_e1234 > 2147483500f)), (_e1234 == _e1234));
let _e1358 = (_e1357 - 1i);
let _e1359 = (_e1274 - 1i);
let _e1361 = select(0i, _e1359, (_e1359 > 0i));
let _e1364 = (_e1274 + 1i);
let _e1367 = (_e1274 + 2i);
let _e1370 = (_e1357 - 4i);
let _e1372 = select(0i, _e1370, (_e1370 > 0i));
let _e1374 = select(_e1372, _e1361, (_e1361 < _e1372));
let _e1387 = (select(0i, _e1321, (_e1321 > 0i)) * _e1308);
let _e1388 = (select(0i, _e1289, (_e1289 > 0i)) * _e1308);
let _e1389 = (select(_e1320, _e1326, (_e1326 < _e1320)) * _e1308);
let _e1390 = (select(_e1320, _e1329, (_e1329 < _e1320)) * _e1308);
let _e1391 = (select(0i, _e1340, (_e1340 > 0i)) * _e1312);
let _e1392 = (select(0i, _e1304, (_e1304 > 0i)) * _e1312);
let _e1393 = (select(_e1339, _e1345, (_e1345 < _e1339)) * _e1312);
let _e1394 = (select(_e1339, _e1348, (_e1348 < _e1339)) * _e1312);
local_26 = type_29(array<i32, 4>(_e1374, _e1374, _e1374, _e1374), array<u32, 6>(bitcast<u32>(((_e1361 - _e1374) * 8i)), bitcast<u32>(((select(0i, _e1274, (_e1274 > 0i)) - _e1374) * 8i)), bitcast<u32>(((select(_e1358, _e1364, (_e1364 < _e1358)) - _e1374) * 8i)), bitcast<u32>(((select(_e1358, _e1367, (_e1367 < _e1358)) - _e1374) * 8i)), 0u, 0u));
local_27 = vec3<f32>((_e1239 - f32(_e1274)), (_e1249 - f32(_e1289)), (_e1259 - f32(_e1304)));
let _e1409 = local_26.member[0u];
let _e1410 = ((_e1392 + _e1388) + _e1409);
let _e1412 = (_e1410 >> bitcast<u32>(2i));
let _e1415 = bitcast<u32>(((_e1410 & 3i) * 8i));
let _e1417 = (bitcast<i32>(_e160) - 1i);
let _e1419 = select(_e1417, _e1412, (_e1412 < _e1417));
let _e1424 = global_2.member[bitcast<u32>(select(0i, _e1419, (_e1419 > 0i)))];
let _e1428 = (_e1412 + 1i);
let _e1430 = select(_e1417, _e1428, (_e1428 < _e1417));
let _e1435 = global_2.member[bitcast<u32>(select(0i, _e1430, (_e1430 > 0i)))];
let _e1442 = ((_e1424 >> bitcast<u32>((_e1415 & 31u))) | ((_e1435 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1415) & 31u))));
let _e1445 = local_26.member_1[0u];
let _e1451 = f32(bitcast<i32>(((_e1442 >> bitcast<u32>((_e1445 & 31u))) & 255u)));
let _e1454 = local_26.member_1[1u];
let _e1460 = f32(bitcast<i32>(((_e1442 >> bitcast<u32>((_e1454 & 31u))) & 255u)));
let _e1463 = local_26.member_1[2u];
let _e1469 = f32(bitcast<i32>(((_e1442 >> bitcast<u32>((_e1463 & 31u))) & 255u)));
let _e1472 = local_26.member_1[3u];
let _e1479 = local_27[0u];
let _e1482 = (_e1451 + ((_e1460 - _e1451) * _e1479));
let _e1483 = local_27[0u];
let _e1486 = (_e1460 + ((_e1469 - _e1460) * _e1483));
let _e1487 = local_27[0u];
let _e1490 = (_e1469 + ((f32(bitcast<i32>(((_e1442 >> bitcast<u32>((_e1472 & 31u))) & 255u))) - _e1469) * _e1487));
let _e1492 = local_26.member[0u];
let _e1493 = ((_e1392 + _e1389) + _e1492);
let _e1495 = (_e1493 >> bitcast<u32>(2i));
let _e1498 = bitcast<u32>(((_e1493 & 3i) * 8i));
let _e1500 = select(_e1417, _e1495, (_e1495 < _e1417));
let _e1505 = global_2.member[bitcast<u32>(select(0i, _e1500, (_e1500 > 0i)))];
let _e1509 = (_e1495 + 1i);
let _e1511 = select(_e1417, _e1509, (_e1509 < _e1417));
let _e1516 = global_2.member[bitcast<u32>(select(0i, _e1511, (_e1511 > 0i)))];
let _e1523 = ((_e1505 >> bitcast<u32>((_e1498 & 31u))) | ((_e1516 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1498) & 31u))));
let _e1524 = local_26.member_1[0u];
let _e1530 = f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1524 & 31u))) & 255u)));
let _e1531 = local_26.member_1[1u];
let _e1537 = f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1531 & 31u))) & 255u)));
let _e1538 = local_26.member_1[2u];
let _e1544 = f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1538 & 31u))) & 255u)));
let _e1545 = local_26.member_1[3u];
let _e1552 = local_27[0u];
let _e1556 = local_27[0u];
let _e1559 = (_e1537 + ((_e1544 - _e1537) * _e1556));
let _e1560 = local_27[0u];
let _e1565 = local_26.member[0u];
let _e1566 = ((_e1393 + _e1388) + _e1565);
let _e1568 = (_e1566 >> bitcast<u32>(2i));
let _e1571 = bitcast<u32>(((_e1566 & 3i) * 8i));
let _e1573 = select(_e1417, _e1568, (_e1568 < _e1417));
let _e1578 = global_2.member[bitcast<u32>(select(0i, _e1573, (_e1573 > 0i)))];
let _e1582 = (_e1568 + 1i);
let _e1584 = select(_e1417, _e1582, (_e1582 < _e1417));
let _e1589 = global_2.member[bitcast<u32>(select(0i, _e1584, (_e1584 > 0i)))];
let _e1596 = ((_e1578 >> bitcast<u32>((_e1571 & 31u))) | ((_e1589 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1571) & 31u))));
let _e1597 = local_26.member_1[0u];
let _e1603 = f32(bitcast<i32>(((_e1596 >> bitcast<u32>((_e1597 & 31u))) & 255u)));
let _e1604 = local_26.member_1[1u];
let _e1610 = f32(bitcast<i32>(((_e1596 >> bitcast<u32>((_e1604 & 31u))) & 255u)));
let _e1611 = local_26.member_1[2u];
let _e1617 = f32(bitcast<i32>(((_e1596 >> bitcast<u32>((_e1611 & 31u))) & 255u)));
let _e1618 = local_26.member_1[3u];
let _e1625 = local_27[0u];
let _e1628 = (_e1603 + ((_e1610 - _e1603) * _e1625));
let _e1629 = local_27[0u];
let _e1632 = (_e1610 + ((_e1617 - _e1610) * _e1629));
let _e1633 = local_27[0u];
let _e1636 = (_e1617 + ((f32(bitcast<i32>(((_e1596 >> bitcast<u32>((_e1618 & 31u))) & 255u))) - _e1617) * _e1633));
let _e1638 = local_26.member[0u];
let _e1639 = ((_e1393 + _e1389) + _e1638);
let _e1641 = (_e1639 >> bitcast<u32>(2i));
let _e1644 = bitcast<u32>(((_e1639 & 3i) * 8i));
let _e1646 = select(_e1417, _e1641, (_e1641 < _e1417));
let _e1651 = global_2.member[bitcast<u32>(select(0i, _e1646, (_e1646 > 0i)))];
let _e1655 = (_e1641 + 1i);
let _e1657 = select(_e1417, _e1655, (_e1655 < _e1417));
let _e1662 = global_2.member[bitcast<u32>(select(0i, _e1657, (_e1657 > 0i)))];
let _e1669 = ((_e1651 >> bitcast<u32>((_e1644 & 31u))) | ((_e1662 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1644) & 31u))));
let _e1670 = local_26.member_1[0u];
let _e1676 = f32(bitcast<i32>(((_e1669 >> bitcast<u32>((_e1670 & 31u))) & 255u)));
let _e1677 = local_26.member_1[1u];
let _e1683 = f32(bitcast<i32>(((_e1669 >> bitcast<u32>((_e1677 & 31u))) & 255u)));
let _e1684 = local_26.member_1[2u];
let _e1690 = f32(bitcast<i32>(((_e1669 >> bitcast<u32>((_e1684 & 31u))) & 255u)));
let _e1691 = local_26.member_1[3u];
let _e1698 = local_27[0u];
let _e1702 = local_27[0u];
let _e1705 = (_e1683 + ((_e1690 - _e1683) * _e1702));
let _e1706 = local_27[0u];
let _e1711 = local_26.member[0u];
let _e1712 = ((_e1392 + _e1387) + _e1711);
let _e1714 = (_e1712 >> bitcast<u32>(2i));
let _e1717 = bitcast<u32>(((_e1712 & 3i) * 8i));
let _e1719 = select(_e1417, _e1714, (_e1714 < _e1417));
let _e1724 = global_2.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1728 = (_e1714 + 1i);
let _e1730 = select(_e1417, _e1728, (_e1728 < _e1417));
let _e1735 = global_2.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1742 = ((_e1724 >> bitcast<u32>((_e1717 & 31u))) | ((_e1735 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1717) & 31u))));
let _e1743 = local_26.member_1[1u];
let _e1749 = f32(bitcast<i32>(((_e1742 >> bitcast<u32>((_e1743 & 31u))) & 255u)));
let _e1750 = local_26.member_1[2u];
let _e1757 = local_27[0u];
let _e1760 = (_e1749 + ((f32(bitcast<i32>(((_e1742 >> bitcast<u32>((_e1750 & 31u))) & 255u))) - _e1749) * _e1757));
let _e1762 = local_26.member[0u];
let _e1763 = ((_e1392 + _e1390) + _e1762);
let _e1765 = (_e1763 >> bitcast<u32>(2i));
let _e1768 = bitcast<u32>(((_e1763 & 3i) * 8i));
let _e1770 = select(_e1417, _e1765, (_e1765 < _e1417));
let _e1775 = global_2.member[bitcast<u32>(select(0i, _e1770, (_e1770 > 0i)))];
let _e1779 = (_e1765 + 1i);
let _e1781 = select(_e1417, _e1779, (_e1779 < _e1417));
let _e1786 = global_2.member[bitcast<u32>(select(0i, _e1781, (_e1781 > 0i)))];
let _e1793 = ((_e1775 >> bitcast<u32>((_e1768 & 31u))) | ((_e1786 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1768) & 31u))));
let _e1794 = local_26.member_1[1u];
let _e1800 = f32(bitcast<i32>(((_e1793 >> bitcast<u32>((_e1794 & 31u))) & 255u)));
let _e1801 = local_26.member_1[2u];
let _e1808 = local_27[0u];
let _e1813 = local_26.member[0u];
let _e1814 = ((_e1393 + _e1387) + _e1813);
let _e1816 = (_e1814 >> bitcast<u32>(2i));
let _e1819 = bitcast<u32>(((_e1814 & 3i) * 8i));
let _e1821 = select(_e1417, _e1816, (_e1816 < _e1417));
let _e1826 = global_2.member[bitcast<u32>(select(0i, _e1821, (_e1821 > 0i)))];
let _e1830 = (_e1816 + 1i);
let _e1832 = select(_e1417, _e1830, (_e1830 < _e1417));
let _e1837 = global_2.member[bitcast<u32>(select(0i, _e1832, (_e1832 > 0i)))];
let _e1844 = ((_e1826 >> bitcast<u32>((_e1819 & 31u))) | ((_e1837 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1819) & 31u))));
let _e1845 = local_26.member_1[1u];
let _e1851 = f32(bitcast<i32>(((_e1844 >> bitcast<u32>((_e1845 & 31u))) & 255u)));
let _e1852 = local_26.member_1[2u];
let _e1859 = local_27[0u];
let _e1862 = (_e1851 + ((f32(bitcast<i32>(((_e1844 >> bitcast<u32>((_e1852 & 31u))) & 255u))) - _e1851) * _e1859));
let _e1864 = local_26.member[0u];
let _e1865 = ((_e1393 + _e1390) + _e1864);
let _e1867 = (_e1865 >> bitcast<u32>(2i));
let _e1870 = bitcast<u32>(((_e1865 & 3i) * 8i));
let _e1872 = select(_e1417, _e1867, (_e1867 < _e1417));
let _e1877 = global_2.member[bitcast<u32>(select(0i, _e1872, (_e1872 > 0i)))];
let _e1881 = (_e1867 + 1i);
let _e1883 = select(_e1417, _e1881, (_e1881 < _e1417));
let _e1888 = global_2.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1895 = ((_e1877 >> bitcast<u32>((_e1870 & 31u))) | ((_e1888 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1870) & 31u))));
let _e1896 = local_26.member_1[1u];
let _e1902 = f32(bitcast<i32>(((_e1895 >> bitcast<u32>((_e1896 & 31u))) & 255u)));
let _e1903 = local_26.member_1[2u];
let _e1910 = local_27[0u];
let _e1915 = local_26.member[0u];
let _e1916 = ((_e1391 + _e1388) + _e1915);
let _e1918 = (_e1916 >> bitcast<u32>(2i));
let _e1921 = bitcast<u32>(((_e1916 & 3i) * 8i));
let _e1923 = select(_e1417, _e1918, (_e1918 < _e1417));
let _e1928 = global_2.member[bitcast<u32>(select(0i, _e1923, (_e1923 > 0i)))];
let _e1932 = (_e1918 + 1i);
let _e1934 = select(_e1417, _e1932, (_e1932 < _e1417));
let _e1939 = global_2.member[bitcast<u32>(select(0i, _e1934, (_e1934 > 0i)))];
let _e1946 = ((_e1928 >> bitcast<u32>((_e1921 & 31u))) | ((_e1939 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1921) & 31u))));
let _e1947 = local_26.member_1[1u];
let _e1953 = f32(bitcast<i32>(((_e1946 >> bitcast<u32>((_e1947 & 31u))) & 255u)));
let _e1954 = local_26.member_1[2u];
let _e1961 = local_27[0u];
let _e1964 = (_e1953 + ((f32(bitcast<i32>(((_e1946 >> bitcast<u32>((_e1954 & 31u))) & 255u))) - _e1953) * _e1961));
let _e1966 = local_26.member[0u];
let _e1967 = ((_e1394 + _e1388) + _e1966);
let _e1969 = (_e1967 >> bitcast<u32>(2i));
let _e1972 = bitcast<u32>(((_e1967 & 3i) * 8i));
let _e1974 = select(_e1417, _e1969, (_e1969 < _e1417));
let _e1979 = global_2.member[bitcast<u32>(select(0i, _e1974, (_e1974 > 0i)))];
let _e1983 = (_e1969 + 1i);
let _e1985 = select(_e1417, _e1983, (_e1983 < _e1417));
let _e1990 = global_2.member[bitcast<u32>(select(0i, _e1985, (_e1985 > 0i)))];
let _e1997 = ((_e1979 >> bitcast<u32>((_e1972 & 31u))) | ((_e1990 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1972) & 31u))));
let _e1998 = local_26.member_1[1u];
let _e2004 = f32(bitcast<i32>(((_e1997 >> bitcast<u32>((_e1998 & 31u))) & 255u)));
let _e2005 = local_26.member_1[2u];
let _e2012 = local_27[0u];
let _e2015 = (_e2004 + ((f32(bitcast<i32>(((_e1997 >> bitcast<u32>((_e2005 & 31u))) & 255u))) - _e2004) * _e2012));
let _e2017 = local_26.member[0u];
let _e2018 = ((_e1391 + _e1389) + _e2017);
let _e2020 = (_e2018 >> bitcast<u32>(2i));
let _e2023 = bitcast<u32>(((_e2018 & 3i) * 8i));
let _e2025 = select(_e1417, _e2020, (_e2020 < _e1417));
let _e2030 = global_2.member[bitcast<u32>(select(0i, _e2025, (_e2025 > 0i)))];
let _e2034 = (_e2020 + 1i);
let _e2036 = select(_e1417, _e2034, (_e2034 < _e1417));
let _e2041 = global_2.member[bitcast<u32>(select(0i, _e2036, (_e2036 > 0i)))];
let _e2048 = ((_e2030 >> bitcast<u32>((_e2023 & 31u))) | ((_e2041 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2023) & 31u))));
let _e2049 = local_26.member_1[1u];
let _e2055 = f32(bitcast<i32>(((_e2048 >> bitcast<u32>((_e2049 & 31u))) & 255u)));
let _e2056 = local_26.member_1[2u];
let _e2063 = local_27[0u];
let _e2068 = local_26.member[0u];
let _e2069 = ((_e1394 + _e1389) + _e2068);
let _e2071 = (_e2069 >> bitcast<u32>(2i));
let _e2074 = bitcast<u32>(((_e2069 & 3i) * 8i));
let _e2076 = select(_e1417, _e2071, (_e2071 < _e1417));
let _e2081 = global_2.member[bitcast<u32>(select(0i, _e2076, (_e2076 > 0i)))];
let _e2085 = (_e2071 + 1i);
let _e2087 = select(_e1417, _e2085, (_e2085 < _e1417));
let _e2092 = global_2.member[bitcast<u32>(select(0i, _e2087, (_e2087 > 0i)))];
let _e2099 = ((_e2081 >> bitcast<u32>((_e2074 & 31u))) | ((_e2092 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2074) & 31u))));
let _e2100 = local_26.member_1[1u];
let _e2106 = f32(bitcast<i32>(((_e2099 >> bitcast<u32>((_e2100 & 31u))) & 255u)));
let _e2107 = local_26.member_1[2u];
let _e2114 = local_27[0u];
let _e2119 = local_27[1u];
let _e2122 = (_e1486 + ((_e1559 - _e1486) * _e2119));
let _e2123 = local_27[1u];
let _e2126 = (_e1632 + ((_e1705 - _e1632) * _e2123));
let _e2127 = local_27[1u];
let _e2130 = (_e1482 + (((_e1530 + ((_e1537 - _e1530) * _e1552)) - _e1482) * _e2127));
let _e2131 = local_27[1u];
let _e2136 = local_27[2u];
let _e2140 = local_27[1u];
let _e2143 = (_e1490 + (((_e1544 + ((f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1545 & 31u))) & 255u))) - _e1544) * _e1560)) - _e1490) * _e2140));
let _e2144 = local_27[1u];
let _e2148 = local_27[2u];
let _e2152 = local_27[1u];
let _e2155 = (_e1760 + ((_e1486 - _e1760) * _e2152));
let _e2156 = local_27[1u];
let _e2160 = local_27[2u];
let _e2164 = local_27[1u];
let _e2167 = (_e1559 + (((_e1800 + ((f32(bitcast<i32>(((_e1793 >> bitcast<u32>((_e1801 & 31u))) & 255u))) - _e1800) * _e1808)) - _e1559) * _e2164));
let _e2168 = local_27[1u];
let _e2172 = local_27[2u];
let _e2176 = local_27[1u];
let _e2179 = (_e1964 + (((_e2055 + ((f32(bitcast<i32>(((_e2048 >> bitcast<u32>((_e2056 & 31u))) & 255u))) - _e2055) * _e2063)) - _e1964) * _e2176));
let _e2180 = local_27[2u];
let _e2184 = local_27[1u];
let _e2188 = local_27[2u];
let _e2192 = local_27[2u];
let _e2199 = global_1.member.member_8.member_6;
let _e2203 = global_1.member.member_8.member_5;
let _e2205 = (((_e2122 + ((_e2126 - _e2122) * _e2192)) - _e2199) * _e2203);
let _e2206 = -(1e9f);
let _e2208 = select(_e2206, _e2205, (_e2205 > _e2206));
let _e2210 = select(1e9f, _e2208, (_e2208 < 1e9f));
let _e2212 = (((_e2130 + (((_e1628 + (((_e1676 + ((_e1683 - _e1676) * _e1698)) - _e1628) * _e2131)) - _e2130) * _e2136)) - _e2199) * _e2203);
let _e2214 = select(_e2206, _e2212, (_e2212 > _e2206));
let _e2216 = select(1e9f, _e2214, (_e2214 < 1e9f));
let _e2218 = (((_e2143 + (((_e1636 + (((_e1690 + ((f32(bitcast<i32>(((_e1669 >> bitcast<u32>((_e1691 & 31u))) & 255u))) - _e1690) * _e1706)) - _e1636) * _e2144)) - _e2143) * _e2148)) - _e2199) * _e2203);
let _e2220 = select(_e2206, _e2218, (_e2218 > _e2206));
let _e2222 = select(1e9f, _e2220, (_e2220 < 1e9f));
let _e2224 = (((_e2155 + (((_e1862 + ((_e1632 - _e1862) * _e2156)) - _e2155) * _e2160)) - _e2199) * _e2203);
let _e2226 = select(_e2206, _e2224, (_e2224 > _e2206));
let _e2228 = select(1e9f, _e2226, (_e2226 < 1e9f));
let _e2230 = (((_e2167 + (((_e1705 + (((_e1902 + ((f32(bitcast<i32>(((_e1895 >> bitcast<u32>((_e1903 & 31u))) & 255u))) - _e1902) * _e1910)) - _e1705) * _e2168)) - _e2167) * _e2172)) - _e2199) * _e2203);
let _e2232 = select(_e2206, _e2230, (_e2230 > _e2206));
let _e2234 = select(1e9f, _e2232, (_e2232 < 1e9f));
let _e2236 = (((_e2179 + ((_e2122 - _e2179) * _e2180)) - _e2199) * _e2203);
let _e2238 = select(_e2206, _e2236, (_e2236 > _e2206));
let _e2240 = select(1e9f, _e2238, (_e2238 < 1e9f));
let _e2242 = (((_e2126 + (((_e2015 + (((_e2106 + ((f32(bitcast<i32>(((_e2099 >> bitcast<u32>((_e2107 & 31u))) & 255u))) - _e2106) * _e2114)) - _e2015) * _e2184)) - _e2126) * _e2188)) - _e2199) * _e2203);
let _e2244 = select(_e2206, _e2242, (_e2242 > _e2206));
let _e2246 = select(1e9f, _e2244, (_e2244 < 1e9f));
local_24 = _e2210;
let _e2247 = local_24;
local_25 = _e2247;
let _e2248 = local_25;
let _e2250 = (bitcast<i32>(_e165) - 1i);
let _e2252 = select(_e2250, 263197i, (263197i < _e2250));
let _e2257 = global_3.member[bitcast<u32>(select(0i, _e2252, (_e2252 > 0i)))];
let _e2258 = bitcast<f32>(_e2257);
let _e2260 = select(_e2250, 263198i, (263198i < _e2250));
let _e2263 = bitcast<u32>(select(0i, _e2260, (_e2260 > 0i)));
let _e2265 = global_3.member[_e2263];
let _e2266 = bitcast<f32>(_e2265);
let _e2268 = select(_e2250, 263199i, (263199i < _e2250));
let _e2273 = global_3.member[bitcast<u32>(select(0i, _e2268, (_e2268 > 0i)))];
let _e2274 = bitcast<f32>(_e2273);
let _e2276 = ((_e2248 - _e2258) * _e2266);
let _e2278 = select(0f, _e2276, (_e2276 > 0f));
let _e2281 = local_25;
let _e2283 = select(_e2250, 263200i, (263200i < _e2250));
let _e2288 = global_3.member[bitcast<u32>(select(0i, _e2283, (_e2283 > 0i)))];
let _e2289 = bitcast<f32>(_e2288);
let _e2291 = select(_e2250, 263201i, (263201i < _e2250));
let _e2296 = global_3.member[bitcast<u32>(select(0i, _e2291, (_e2291 > 0i)))];
let _e2297 = bitcast<f32>(_e2296);
let _e2299 = select(_e2250, 263202i, (263202i < _e2250));
let _e2304 = global_3.member[bitcast<u32>(select(0i, _e2299, (_e2299 > 0i)))];
let _e2305 = bitcast<f32>(_e2304);
let _e2307 = ((_e2281 - _e2289) * _e2297);
let _e2309 = select(0f, _e2307, (_e2307 > 0f));
let _e2313 = local_25;
let _e2315 = select(_e2250, 263203i, (263203i < _e2250));
let _e2320 = global_3.member[bitcast<u32>(select(0i, _e2315, (_e2315 > 0i)))];
let _e2321 = bitcast<f32>(_e2320);
let _e2323 = select(_e2250, 263204i, (263204i < _e2250));
let _e2328 = global_3.member[bitcast<u32>(select(0i, _e2323, (_e2323 > 0i)))];
let _e2329 = bitcast<f32>(_e2328);
let _e2331 = select(_e2250, 263205i, (263205i < _e2250));
let _e2336 = global_3.member[bitcast<u32>(select(0i, _e2331, (_e2331 > 0i)))];
let _e2337 = bitcast<f32>(_e2336);
let _e2339 = ((_e2313 - _e2321) * _e2329);
let _e2341 = select(0f, _e2339, (_e2339 > 0f));
let _e2344 = local_25;
let _e2346 = select(_e2250, 263206i, (263206i < _e2250));
let _e2351 = global_3.member[bitcast<u32>(select(0i, _e2346, (_e2346 > 0i)))];
let _e2352 = bitcast<f32>(_e2351);
let _e2354 = select(_e2250, 263207i, (263207i < _e2250));
let _e2359 = global_3.member[bitcast<u32>(select(0i, _e2354, (_e2354 > 0i)))];
let _e2360 = bitcast<f32>(_e2359);
let _e2362 = select(_e2250, 263208i, (263208i < _e2250));
let _e2367 = global_3.member[bitcast<u32>(select(0i, _e2362, (_e2362 > 0i)))];
let _e2368 = bitcast<f32>(_e2367);
let _e2370 = ((_e2344 - _e2352) * _e2360);
let _e2372 = select(0f, _e2370, (_e2370 > 0f));
let _e2376 = ((select(_e2274, _e2278, (_e2278 < _e2274)) + select(_e2305, _e2309, (_e2309 < _e2305))) + (select(_e2337, _e2341, (_e2341 < _e2337)) + select(_e2368, _e2372, (_e2372 < _e2368))));
let _e2378 = select(0f, _e2376, (_e2376 > 0f));
let _e2380 = select(1023f, _e2378, (_e2378 < 1023f));
let _e2387 = select(0i, select(select(i32(_e2380), i32(-2147483648), (_e2380 < -2147483600f)), 2147483647i, (_e2380 > 2147483500f)), (_e2380 == _e2380));
let _e2391 = (_e2387 - select(0i, 1i, (_e2380 < f32(_e2387))));
let _e2392 = (262147i + _e2391);
let _e2394 = select(_e2250, _e2392, (_e2392 < _e2250));
let _e2400 = global_3.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2410 = select(_e2250, 262146i, (262146i < _e2250));
let _e2416 = global_3.member[bitcast<u32>(select(0i, _e2410, (_e2410 > 0i)))];
let _e2417 = bitcast<f32>(_e2416);
let _e2418 = (f32((bitcast<i32>((_e2400 & 4095u)) - 2048i)) * _e2417);
let _e2420 = select(_e2250, 262144i, (262144i < _e2250));
let _e2426 = global_3.member[bitcast<u32>(select(0i, _e2420, (_e2420 > 0i)))];
let _e2427 = bitcast<f32>(_e2426);
let _e2429 = select(_e2250, 262145i, (262145i < _e2250));
let _e2435 = global_3.member[bitcast<u32>(select(0i, _e2429, (_e2429 > 0i)))];
let _e2436 = bitcast<f32>(_e2435);
let _e2442 = ((_e2427 + (f32(bitcast<i32>((_e2400 >> bitcast<u32>(12u)))) * _e2436)) + (_e2418 * (_e2376 - f32(_e2391))));
let _e2445 = global_3.member[_e2263];
let _e2447 = local_24;
let _e2450 = local_24;
let _e2453 = local_24;
let _e2457 = select(_e2250, 263209i, (263209i < _e2250));
let _e2463 = global_3.member[bitcast<u32>(select(0i, _e2457, (_e2457 > 0i)))];
let _e2465 = local_24;
let _e2468 = select(_e2250, 263210i, (263210i < _e2250));
let _e2474 = global_3.member[bitcast<u32>(select(0i, _e2468, (_e2468 > 0i)))];
let _e2476 = local_24;
let _e2480 = (_e2418 * select(0f, select(select(select(bitcast<f32>(_e2445), _e2297, (_e2447 >= _e2289)), _e2329, (_e2450 >= _e2321)), _e2360, (_e2453 >= _e2352)), ((_e2465 >= bitcast<f32>(_e2463)) && (_e2476 <= bitcast<f32>(_e2474)))));
if _e1228 {
let _e2487 = ((0.5f * (_e2222 - _e2216)) * _e2480);
let _e2488 = ((0.5f * (_e2234 - _e2228)) * _e2480);
let _e2489 = ((0.5f * (_e2246 - _e2240)) * _e2480);
phi_7267_ = type_32(_e2442, vec3<f32>(_e2487, _e2488, _e2489), vec3<f32>((_e2487 * _e2442), (_e2488 * _e2442), (_e2489 * _e2442)));
} else {
local_22 = _e2216;
let _e2496 = local_22;
local_23 = _e2496;
let _e2497 = local_23;
let _e2499 = ((_e2497 - _e2258) * _e2266);
let _e2501 = select(0f, _e2499, (_e2499 > 0f));
let _e2504 = local_23;
let _e2506 = ((_e2504 - _e2289) * _e2297);
let _e2508 = select(0f, _e2506, (_e2506 > 0f));
let _e2512 = local_23;
let _e2514 = ((_e2512 - _e2321) * _e2329);
let _e2516 = select(0f, _e2514, (_e2514 > 0f));
let _e2519 = local_23;
let _e2521 = ((_e2519 - _e2352) * _e2360);
let _e2523 = select(0f, _e2521, (_e2521 > 0f));
let _e2527 = ((select(_e2274, _e2501, (_e2501 < _e2274)) + select(_e2305, _e2508, (_e2508 < _e2305))) + (select(_e2337, _e2516, (_e2516 < _e2337)) + select(_e2368, _e2523, (_e2523 < _e2368))));
let _e2529 = select(0f, _e2527, (_e2527 > 0f));
let _e2531 = select(1023f, _e2529, (_e2529 < 1023f));
let _e2538 = select(0i, select(select(i32(_e2531), i32(-2147483648), (_e2531 < -2147483600f)), 2147483647i, (_e2531 > 2147483500f)), (_e2531 == _e2531));
let _e2542 = (_e2538 - select(0i, 1i, (_e2531 < f32(_e2538))));
let _e2543 = (262147i + _e2542);
let _e2545 = select(_e2250, _e2543, (_e2543 < _e2250));
let _e2551 = global_3.member[bitcast<u32>(select(0i, _e2545, (_e2545 > 0i)))];
let _e2566 = ((_e2427 + (f32(bitcast<i32>((_e2551 >> bitcast<u32>(12u)))) * _e2436)) + ((f32((bitcast<i32>((_e2551 & 4095u)) - 2048i)) * _e2417) * (_e2527 - f32(_e2542))));
local_20 = _e2222;
let _e2567 = local_20;
local_21 = _e2567;
let _e2568 = local_21;
let _e2570 = ((_e2568 - _e2258) * _e2266);
let _e2572 = select(0f, _e2570, (_e2570 > 0f));
let _e2575 = local_21;
let _e2577 = ((_e2575 - _e2289) * _e2297);
let _e2579 = select(0f, _e2577, (_e2577 > 0f));
let _e2583 = local_21;
let _e2585 = ((_e2583 - _e2321) * _e2329);
let _e2587 = select(0f, _e2585, (_e2585 > 0f));
let _e2590 = local_21;
let _e2592 = ((_e2590 - _e2352) * _e2360);
let _e2594 = select(0f, _e2592, (_e2592 > 0f));
let _e2598 = ((select(_e2274, _e2572, (_e2572 < _e2274)) + select(_e2305, _e2579, (_e2579 < _e2305))) + (select(_e2337, _e2587, (_e2587 < _e2337)) + select(_e2368, _e2594, (_e2594 < _e2368))));
let _e2600 = select(0f, _e2598, (_e2598 > 0f));
let _e2602 = select(1023f, _e2600, (_e2600 < 1023f));
let _e2609 = select(0i, select(select(i32(_e2602), i32(-2147483648), (_e2602 < -2147483600f)), 2147483647i, (_e2602 > 2147483500f)), (_e2602 == _e2602));
let _e2613 = (_e2609 - select(0i, 1i, (_e2602 < f32(_e2609))));
let _e2614 = (262147i + _e2613);
let _e2616 = select(_e2250, _e2614, (_e2614 < _e2250));
let _e2622 = global_3.member[bitcast<u32>(select(0i, _e2616, (_e2616 > 0i)))];
let _e2637 = ((_e2427 + (f32(bitcast<i32>((_e2622 >> bitcast<u32>(12u)))) * _e2436)) + ((f32((bitcast<i32>((_e2622 & 4095u)) - 2048i)) * _e2417) * (_e2598 - f32(_e2613))));
local_18 = _e2228;
let _e2638 = local_18;
local_19 = _e2638;
let _e2639 = local_19;
let _e2641 = ((_e2639 - _e2258) * _e2266);
let _e2643 = select(0f, _e2641, (_e2641 > 0f));
let _e2646 = local_19;
let _e2648 = ((_e2646 - _e2289) * _e2297);
let _e2650 = select(0f, _e2648, (_e2648 > 0f));
let _e2654 = local_19;
let _e2656 = ((_e2654 - _e2321) * _e2329);
let _e2658 = select(0f, _e2656, (_e2656 > 0f));
let _e2661 = local_19;
let _e2663 = ((_e2661 - _e2352) * _e2360);
let _e2665 = select(0f, _e2663, (_e2663 > 0f));
let _e2669 = ((select(_e2274, _e2643, (_e2643 < _e2274)) + select(_e2305, _e2650, (_e2650 < _e2305))) + (select(_e2337, _e2658, (_e2658 < _e2337)) + select(_e2368, _e2665, (_e2665 < _e2368))));
let _e2671 = select(0f, _e2669, (_e2669 > 0f));
let _e2673 = select(1023f, _e2671, (_e2671 < 1023f));
let _e2680 = select(0i, select(select(i32(_e2673), i32(-2147483648), (_e2673 < -2147483600f)), 2147483647i, (_e2673 > 2147483500f)), (_e2673 == _e2673));
let _e2684 = (_e2680 - select(0i, 1i, (_e2673 < f32(_e2680))));
let _e2685 = (262147i + _e2684);
let _e2687 = select(_e2250, _e2685, (_e2685 < _e2250));
let _e2693 = global_3.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2708 = ((_e2427 + (f32(bitcast<i32>((_e2693 >> bitcast<u32>(12u)))) * _e2436)) + ((f32((bitcast<i32>((_e2693 & 4095u)) - 2048i)) * _e2417) * (_e2669 - f32(_e2684))));
local_16 = _e2234;
let _e2709 = local_16;
local_17 = _e2709;
let _e2710 = local_17;
let _e2712 = ((_e2710 - _e2258) * _e2266);
let _e2714 = select(0f, _e2712, (_e2712 > 0f));
let _e2717 = local_17;
let _e2719 = ((_e2717 - _e2289) * _e2297);
let _e2721 = select(0f, _e2719, (_e2719 > 0f));
let _e2725 = local_17;
let _e2727 = ((_e2725 - _e2321) * _e2329);
let _e2729 = select(0f, _e2727, (_e2727 > 0f));
let _e2732 = local_17;
let _e2734 = ((_e2732 - _e2352) * _e2360);
let _e2736 = select(0f, _e2734, (_e2734 > 0f));
let _e2740 = ((select(_e2274, _e2714, (_e2714 < _e2274)) + select(_e2305, _e2721, (_e2721 < _e2305))) + (select(_e2337, _e2729, (_e2729 < _e2337)) + select(_e2368, _e2736, (_e2736 < _e2368))));
let _e2742 = select(0f, _e2740, (_e2740 > 0f));
let _e2744 = select(1023f, _e2742, (_e2742 < 1023f));
let _e2751 = select(0i, select(select(i32(_e2744), i32(-2147483648), (_e2744 < -2147483600f)), 2147483647i, (_e2744 > 2147483500f)), (_e2744 == _e2744));
let _e2755 = (_e2751 - select(0i, 1i, (_e2744 < f32(_e2751))));
let _e2756 = (262147i + _e2755);
let _e2758 = select(_e2250, _e2756, (_e2756 < _e2250));
let _e2764 = global_3.member[bitcast<u32>(select(0i, _e2758, (_e2758 > 0i)))];
let _e2779 = ((_e2427 + (f32(bitcast<i32>((_e2764 >> bitcast<u32>(12u)))) * _e2436)) + ((f32((bitcast<i32>((_e2764 & 4095u)) - 2048i)) * _e2417) * (_e2740 - f32(_e2755))));
local_14 = _e2240;
let _e2780 = local_14;
local_15 = _e2780;
let _e2781 = local_15;
let _e2783 = ((_e2781 - _e2258) * _e2266);
let _e2785 = select(0f, _e2783, (_e2783 > 0f));
let _e2788 = local_15;
let _e2790 = ((_e2788 - _e2289) * _e2297);
let _e2792 = select(0f, _e2790, (_e2790 > 0f));
let _e2796 = local_15;
let _e2798 = ((_e2796 - _e2321) * _e2329);
let _e2800 = select(0f, _e2798, (_e2798 > 0f));
let _e2803 = local_15;
let _e2805 = ((_e2803 - _e2352) * _e2360);
let _e2807 = select(0f, _e2805, (_e2805 > 0f));
let _e2811 = ((select(_e2274, _e2785, (_e2785 < _e2274)) + select(_e2305, _e2792, (_e2792 < _e2305))) + (select(_e2337, _e2800, (_e2800 < _e2337)) + select(_e2368, _e2807, (_e2807 < _e2368))));
let _e2813 = select(0f, _e2811, (_e2811 > 0f));
let _e2815 = select(1023f, _e2813, (_e2813 < 1023f));
let _e2822 = select(0i, select(select(i32(_e2815), i32(-2147483648), (_e2815 < -2147483600f)), 2147483647i, (_e2815 > 2147483500f)), (_e2815 == _e2815));
let _e2826 = (_e2822 - select(0i, 1i, (_e2815 < f32(_e2822))));
let _e2827 = (262147i + _e2826);
let _e2829 = select(_e2250, _e2827, (_e2827 < _e2250));
let _e2835 = global_3.member[bitcast<u32>(select(0i, _e2829, (_e2829 > 0i)))];
let _e2850 = ((_e2427 + (f32(bitcast<i32>((_e2835 >> bitcast<u32>(12u)))) * _e2436)) + ((f32((bitcast<i32>((_e2835 & 4095u)) - 2048i)) * _e2417) * (_e2811 - f32(_e2826))));
local_12 = _e2246;
let _e2851 = local_12;
local_13 = _e2851;
let _e2852 = local_13;
let _e2854 = ((_e2852 - _e2258) * _e2266);
let _e2856 = select(0f, _e2854, (_e2854 > 0f));
let _e2859 = local_13;
let _e2861 = ((_e2859 - _e2289) * _e2297);
let _e2863 = select(0f, _e2861, (_e2861 > 0f));
let _e2867 = local_13;
let _e2869 = ((_e2867 - _e2321) * _e2329);
let _e2871 = select(0f, _e2869, (_e2869 > 0f));
let _e2874 = local_13;
let _e2876 = ((_e2874 - _e2352) * _e2360);
let _e2878 = select(0f, _e2876, (_e2876 > 0f));
let _e2882 = ((select(_e2274, _e2856, (_e2856 < _e2274)) + select(_e2305, _e2863, (_e2863 < _e2305))) + (select(_e2337, _e2871, (_e2871 < _e2337)) + select(_e2368, _e2878, (_e2878 < _e2368))));
let _e2884 = select(0f, _e2882, (_e2882 > 0f));
let _e2886 = select(1023f, _e2884, (_e2884 < 1023f));
let _e2893 = select(0i, select(select(i32(_e2886), i32(-2147483648), (_e2886 < -2147483600f)), 2147483647i, (_e2886 > 2147483500f)), (_e2886 == _e2886));
let _e2897 = (_e2893 - select(0i, 1i, (_e2886 < f32(_e2893))));
let _e2898 = (262147i + _e2897);
let _e2900 = select(_e2250, _e2898, (_e2898 < _e2250));
let _e2906 = global_3.member[bitcast<u32>(select(0i, _e2900, (_e2900 > 0i)))];
let _e2921 = ((_e2427 + (f32(bitcast<i32>((_e2906 >> bitcast<u32>(12u)))) * _e2436)) + ((f32((bitcast<i32>((_e2906 & 4095u)) - 2048i)) * _e2417) * (_e2882 - f32(_e2897))));
let _e2922 = (_e2637 - _e2566);
let _e2924 = (_e2779 - _e2708);
let _e2926 = (_e2921 - _e2850);
phi_7267_ = type_32(_e2442, vec3<f32>((0.5f * _e2922), (0.5f * _e2924), (0.5f * _e2926)), vec3<f32>((0.25f * (_e2922 * (_e2637 + _e2566))), (0.25f * (_e2924 * (_e2779 + _e2708))), (0.25f * (_e2926 * (_e2921 + _e2850)))));
}
let _e2941 = phi_7267_;
let _e2956 = select(0f, 1f, ((((((_e1208 >= -0.5f) && (_e1208 <= _e1235)) && (_e1214 >= -0.5f)) && (_e1214 <= _e1245)) && (_e1220 >= -0.5f)) && (_e1220 <= _e1255)));
let _e2958 = (0.5f * (_e2222 - _e2216));
let _e2960 = (0.5f * (_e2234 - _e2228));
let _e2962 = (0.5f * (_e2246 - _e2240));
let _e2968 = global_1.member.member_8.member.member.member;
let _e2974 = global_1.member.member_8.member.member.member_1;
let _e2980 = global_1.member.member_8.member.member.member_2;
let _e2986 = global_1.member.member_8.member_1.member.member;
let _e2992 = global_1.member.member_8.member_1.member.member_1;
let _e2998 = global_1.member.member_8.member_1.member.member_2;
let _e3004 = global_1.member.member_8.member_2.member.member;
let _e3010 = global_1.member.member_8.member_2.member.member_1;
let _e3016 = global_1.member.member_8.member_2.member.member_2;
phi_8030_ = type_33(_e2210, vec3<f32>(((((_e2968 * _e2958) + (_e2986 * _e2960)) + (_e3004 * _e2962)) * _e2956), ((((_e2974 * _e2958) + (_e2992 * _e2960)) + (_e3010 * _e2962)) * _e2956), ((((_e2980 * _e2958) + (_e2998 * _e2960)) + (_e3016 * _e2962)) * _e2956)), _e2941.member, vec3<f32>(((((_e2968 * _e2941.member_2.x) + (_e2986 * _e2941.member_2.y)) + (_e3004 * _e2941.member_2.z)) * _e2956), ((((_e2974 * _e2941.member_2.x) + (_e2992 * _e2941.member_2.y)) + (_e3010 * _e2941.member_2.z)) * _e2956), ((((_e2980 * _e2941.member_2.x) + (_e2998 * _e2941.member_2.y)) + (_e3016 * _e2941.member_2.z)) * _e2956)), vec3<f32>(((((_e2968 * _e2941.member_1.x) + (_e2986 * _e2941.member_1.y)) + (_e3004 * _e2941.member_1.z)) * _e2956), ((((_e2974 * _e2941.member_1.x) + (_e2992 * _e2941.member_1.y)) + (_e3010 * _e2941.member_1.z)) * _e2956), ((((_e2980 * _e2941.member_1.x) + (_e2998 * _e2941.member_1.y)) + (_e3016 * _e2941.member_1.z)) * _e2956)));
} else {
let _e3085 = global_1.member.member_8.member_3.member;
let _e3086 = (_e3085 - 0.5f);
let _e3088 = select(-0.5f, _e1208, (_e1208 > -0.5f));
let _e3090 = select(_e3086, _e3088, (_e3088 < _e3086));
let _e3095 = global_1.member.member_8.member_3.member_1;
let _e3096 = (_e3095 - 0.5f);
let _e3098 = select(-0.5f, _e1214, (_e1214 > -0.5f));
let _e3100 = select(_e3096, _e3098, (_e3098 < _e3096));
let _e3105 = global_1.member.member_8.member_3.member_2;
let _e3106 = (_e3105 - 0.5f);
let _e3108 = select(-0.5f, _e1220, (_e1220 > -0.5f));
let _e3110 = select(_e3106, _e3108, (_e3108 < _e3106));
let _e3112 = select(-1f, _e3090, (_e3090 > -1f));
let _e3114 = select(_e3085, _e3112, (_e3112 < _e3085));
let _e3121 = select(0i, select(select(i32(_e3114), i32(-2147483648), (_e3114 < -2147483600f)), 2147483647i, (_e3114 > 2147483500f)), (_e3114 == _e3114));
let _e3125 = (_e3121 - select(0i, 1i, (_e3114 < f32(_e3121))));
let _e3127 = select(-1f, _e3100, (_e3100 > -1f));
let _e3129 = select(_e3095, _e3127, (_e3127 < _e3095));
let _e3136 = select(0i, select(select(i32(_e3129), i32(-2147483648), (_e3129 < -2147483600f)), 2147483647i, (_e3129 > 2147483500f)), (_e3129 == _e3129));
let _e3140 = (_e3136 - select(0i, 1i, (_e3129 < f32(_e3136))));
let _e3142 = select(-1f, _e3110, (_e3110 > -1f));
let _e3144 = select(_e3105, _e3142, (_e3142 < _e3105));
let _e3151 = select(0i, select(select(i32(_e3144), i32(-2147483648), (_e3144 < -2147483600f)), 2147483647i, (_e3144 > 2147483500f)), (_e3144 == _e3144));
let _e3155 = (_e3151 - select(0i, 1i, (_e3144 < f32(_e3151))));
let _e3159 = global_1.member.member_8.member_7;
let _e3163 = global_1.member.member_8.member_8;
let _e3171 = (select(0i, select(select(i32(_e3095), i32(-2147483648), (_e3095 < -2147483600f)), 2147483647i, (_e3095 > 2147483500f)), (_e3095 == _e3095)) - 1i);
let _e3174 = (_e3140 + 1i);
let _e3184 = (select(0i, select(select(i32(_e3105), i32(-2147483648), (_e3105 < -2147483600f)), 2147483647i, (_e3105 > 2147483500f)), (_e3105 == _e3105)) - 1i);
let _e3187 = (_e3155 + 1i);
let _e3196 = select(0i, select(select(i32(_e3085), i32(-2147483648), (_e3085 < -2147483600f)), 2147483647i, (_e3085 > 2147483500f)), (_e3085 == _e3085));
let _e3197 = (_e3196 - 1i);
let _e3198 = (_e3125 - 1i);
let _e3200 = select(0i, _e3198, (_e3198 > 0i));
let _e3203 = (_e3125 + 1i);
let _e3206 = (_e3125 + 2i);
let _e3209 = (_e3196 - 4i);
let _e3211 = select(0i, _e3209, (_e3209 > 0i));
let _e3213 = select(_e3211, _e3200, (_e3200 < _e3211));
let _e3226 = (select(0i, _e3140, (_e3140 > 0i)) * _e3159);
let _e3227 = (select(_e3171, _e3174, (_e3174 < _e3171)) * _e3159);
let _e3228 = (select(0i, _e3155, (_e3155 > 0i)) * _e3163);
let _e3229 = (select(_e3184, _e3187, (_e3187 < _e3184)) * _e3163);
local_10 = type_29(array<i32, 4>(_e3213, _e3213, _e3213, _e3213), array<u32, 6>(bitcast<u32>(((_e3200 - _e3213) * 8i)), bitcast<u32>(((select(0i, _e3125, (_e3125 > 0i)) - _e3213) * 8i)), bitcast<u32>(((select(_e3197, _e3203, (_e3203 < _e3197)) - _e3213) * 8i)), bitcast<u32>(((select(_e3197, _e3206, (_e3206 < _e3197)) - _e3213) * 8i)), 0u, 0u));
local_11 = vec3<f32>((_e3090 - f32(_e3125)), (_e3100 - f32(_e3140)), (_e3110 - f32(_e3155)));
let _e3244 = local_10.member[0u];
let _e3245 = ((_e3228 + _e3226) + _e3244);
let _e3247 = (_e3245 >> bitcast<u32>(2i));
let _e3250 = bitcast<u32>(((_e3245 & 3i) * 8i));
let _e3252 = (bitcast<i32>(_e160) - 1i);
let _e3254 = select(_e3252, _e3247, (_e3247 < _e3252));
let _e3259 = global_2.member[bitcast<u32>(select(0i, _e3254, (_e3254 > 0i)))];
let _e3263 = (_e3247 + 1i);
let _e3265 = select(_e3252, _e3263, (_e3263 < _e3252));
let _e3270 = global_2.member[bitcast<u32>(select(0i, _e3265, (_e3265 > 0i)))];
let _e3277 = ((_e3259 >> bitcast<u32>((_e3250 & 31u))) | ((_e3270 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3250) & 31u))));
let _e3280 = local_10.member_1[1u];
let _e3286 = f32(bitcast<i32>(((_e3277 >> bitcast<u32>((_e3280 & 31u))) & 255u)));
let _e3289 = local_10.member_1[2u];
let _e3296 = local_11[0u];
let _e3299 = (_e3286 + ((f32(bitcast<i32>(((_e3277 >> bitcast<u32>((_e3289 & 31u))) & 255u))) - _e3286) * _e3296));
let _e3301 = local_10.member[0u];
let _e3302 = ((_e3228 + _e3227) + _e3301);
let _e3304 = (_e3302 >> bitcast<u32>(2i));
let _e3307 = bitcast<u32>(((_e3302 & 3i) * 8i));
let _e3309 = select(_e3252, _e3304, (_e3304 < _e3252));
let _e3314 = global_2.member[bitcast<u32>(select(0i, _e3309, (_e3309 > 0i)))];
let _e3318 = (_e3304 + 1i);
let _e3320 = select(_e3252, _e3318, (_e3318 < _e3252));
let _e3325 = global_2.member[bitcast<u32>(select(0i, _e3320, (_e3320 > 0i)))];
let _e3332 = ((_e3314 >> bitcast<u32>((_e3307 & 31u))) | ((_e3325 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3307) & 31u))));
let _e3333 = local_10.member_1[1u];
let _e3339 = f32(bitcast<i32>(((_e3332 >> bitcast<u32>((_e3333 & 31u))) & 255u)));
let _e3340 = local_10.member_1[2u];
let _e3347 = local_11[0u];
let _e3352 = local_11[1u];
let _e3355 = (_e3299 + (((_e3339 + ((f32(bitcast<i32>(((_e3332 >> bitcast<u32>((_e3340 & 31u))) & 255u))) - _e3339) * _e3347)) - _e3299) * _e3352));
let _e3357 = local_10.member[0u];
let _e3358 = ((_e3229 + _e3226) + _e3357);
let _e3360 = (_e3358 >> bitcast<u32>(2i));
let _e3363 = bitcast<u32>(((_e3358 & 3i) * 8i));
let _e3365 = select(_e3252, _e3360, (_e3360 < _e3252));
let _e3370 = global_2.member[bitcast<u32>(select(0i, _e3365, (_e3365 > 0i)))];
let _e3374 = (_e3360 + 1i);
let _e3376 = select(_e3252, _e3374, (_e3374 < _e3252));
let _e3381 = global_2.member[bitcast<u32>(select(0i, _e3376, (_e3376 > 0i)))];
let _e3388 = ((_e3370 >> bitcast<u32>((_e3363 & 31u))) | ((_e3381 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3363) & 31u))));
let _e3389 = local_10.member_1[1u];
let _e3395 = f32(bitcast<i32>(((_e3388 >> bitcast<u32>((_e3389 & 31u))) & 255u)));
let _e3396 = local_10.member_1[2u];
let _e3403 = local_11[0u];
let _e3406 = (_e3395 + ((f32(bitcast<i32>(((_e3388 >> bitcast<u32>((_e3396 & 31u))) & 255u))) - _e3395) * _e3403));
let _e3408 = local_10.member[0u];
let _e3409 = ((_e3229 + _e3227) + _e3408);
let _e3411 = (_e3409 >> bitcast<u32>(2i));
let _e3414 = bitcast<u32>(((_e3409 & 3i) * 8i));
let _e3416 = select(_e3252, _e3411, (_e3411 < _e3252));
let _e3421 = global_2.member[bitcast<u32>(select(0i, _e3416, (_e3416 > 0i)))];
let _e3425 = (_e3411 + 1i);
let _e3427 = select(_e3252, _e3425, (_e3425 < _e3252));
let _e3432 = global_2.member[bitcast<u32>(select(0i, _e3427, (_e3427 > 0i)))];
let _e3439 = ((_e3421 >> bitcast<u32>((_e3414 & 31u))) | ((_e3432 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3414) & 31u))));
let _e3440 = local_10.member_1[1u];
let _e3446 = f32(bitcast<i32>(((_e3439 >> bitcast<u32>((_e3440 & 31u))) & 255u)));
let _e3447 = local_10.member_1[2u];
let _e3454 = local_11[0u];
let _e3458 = local_11[1u];
let _e3463 = local_11[2u];
let _e3470 = global_1.member.member_8.member_6;
let _e3474 = global_1.member.member_8.member_5;
let _e3476 = (((_e3355 + (((_e3406 + (((_e3446 + ((f32(bitcast<i32>(((_e3439 >> bitcast<u32>((_e3447 & 31u))) & 255u))) - _e3446) * _e3454)) - _e3406) * _e3458)) - _e3355) * _e3463)) - _e3470) * _e3474);
let _e3477 = -(1e9f);
let _e3479 = select(_e3477, _e3476, (_e3476 > _e3477));
phi_8030_ = type_33(select(1e9f, _e3479, (_e3479 < 1e9f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e3484 = phi_8030_;
let _e3489 = global_1.member.member_8.member_3.member;
let _e3490 = (_e3489 - 0.5f);
let _e3492 = select(-0.5f, _e1172, (_e1172 > -0.5f));
let _e3494 = select(_e3490, _e3492, (_e3492 < _e3490));
let _e3499 = global_1.member.member_8.member_3.member_1;
let _e3500 = (_e3499 - 0.5f);
let _e3502 = select(-0.5f, _e1187, (_e1187 > -0.5f));
let _e3504 = select(_e3500, _e3502, (_e3502 < _e3500));
let _e3509 = global_1.member.member_8.member_3.member_2;
let _e3510 = (_e3509 - 0.5f);
let _e3512 = select(-0.5f, _e1202, (_e1202 > -0.5f));
let _e3514 = select(_e3510, _e3512, (_e3512 < _e3510));
let _e3516 = select(-1f, _e3494, (_e3494 > -1f));
let _e3518 = select(_e3489, _e3516, (_e3516 < _e3489));
let _e3525 = select(0i, select(select(i32(_e3518), i32(-2147483648), (_e3518 < -2147483600f)), 2147483647i, (_e3518 > 2147483500f)), (_e3518 == _e3518));
let _e3529 = (_e3525 - select(0i, 1i, (_e3518 < f32(_e3525))));
let _e3531 = select(-1f, _e3504, (_e3504 > -1f));
let _e3533 = select(_e3499, _e3531, (_e3531 < _e3499));
let _e3540 = select(0i, select(select(i32(_e3533), i32(-2147483648), (_e3533 < -2147483600f)), 2147483647i, (_e3533 > 2147483500f)), (_e3533 == _e3533));
let _e3544 = (_e3540 - select(0i, 1i, (_e3533 < f32(_e3540))));
let _e3546 = select(-1f, _e3514, (_e3514 > -1f));
let _e3548 = select(_e3509, _e3546, (_e3546 < _e3509));
let _e3555 = select(0i, select(select(i32(_e3548), i32(-2147483648), (_e3548 < -2147483600f)), 2147483647i, (_e3548 > 2147483500f)), (_e3548 == _e3548));
let _e3559 = (_e3555 - select(0i, 1i, (_e3548 < f32(_e3555))));
let _e3563 = global_1.member.member_8.member_7;
let _e3567 = global_1.member.member_8.member_8;
let _e3575 = (select(0i, select(select(i32(_e3499), i32(-2147483648), (_e3499 < -2147483600f)), 2147483647i, (_e3499 > 2147483500f)), (_e3499 == _e3499)) - 1i);
let _e3578 = (_e3544 + 1i);
let _e3588 = (select(0i, select(select(i32(_e3509), i32(-2147483648), (_e3509 < -2147483600f)), 2147483647i, (_e3509 > 2147483500f)), (_e3509 == _e3509)) - 1i);
let _e3591 = (_e3559 + 1i);
let _e3600 = select(0i, select(select(i32(_e3489), i32(-2147483648), (_e3489 < -2147483600f)), 2147483647i, (_e3489 > 2147483500f)), (_e3489 == _e3489));
let _e3601 = (_e3600 - 1i);
let _e3602 = (_e3529 - 1i);
let _e3604 = select(0i, _e3602, (_e3602 > 0i));
let _e3607 = (_e3529 + 1i);
let _e3610 = (_e3529 + 2i);
let _e3613 = (_e3600 - 4i);
let _e3615 = select(0i, _e3613, (_e3613 > 0i));
let _e3617 = select(_e3615, _e3604, (_e3604 < _e3615));
let _e3630 = (select(0i, _e3544, (_e3544 > 0i)) * _e3563);
let _e3631 = (select(_e3575, _e3578, (_e3578 < _e3575)) * _e3563);
let _e3632 = (select(0i, _e3559, (_e3559 > 0i)) * _e3567);
let _e3633 = (select(_e3588, _e3591, (_e3591 < _e3588)) * _e3567);
local_8 = type_29(array<i32, 4>(_e3617, _e3617, _e3617, _e3617), array<u32, 6>(bitcast<u32>(((_e3604 - _e3617) * 8i)), bitcast<u32>(((select(0i, _e3529, (_e3529 > 0i)) - _e3617) * 8i)), bitcast<u32>(((select(_e3601, _e3607, (_e3607 < _e3601)) - _e3617) * 8i)), bitcast<u32>(((select(_e3601, _e3610, (_e3610 < _e3601)) - _e3617) * 8i)), 0u, 0u));
local_9 = vec3<f32>((_e3494 - f32(_e3529)), (_e3504 - f32(_e3544)), (_e3514 - f32(_e3559)));
let _e3648 = local_8.member[0u];
let _e3649 = ((_e3632 + _e3630) + _e3648);
let _e3651 = (_e3649 >> bitcast<u32>(2i));
let _e3654 = bitcast<u32>(((_e3649 & 3i) * 8i));
let _e3656 = (bitcast<i32>(_e160) - 1i);
let _e3658 = select(_e3656, _e3651, (_e3651 < _e3656));
let _e3663 = global_2.member[bitcast<u32>(select(0i, _e3658, (_e3658 > 0i)))];
let _e3667 = (_e3651 + 1i);
let _e3669 = select(_e3656, _e3667, (_e3667 < _e3656));
let _e3674 = global_2.member[bitcast<u32>(select(0i, _e3669, (_e3669 > 0i)))];
let _e3681 = ((_e3663 >> bitcast<u32>((_e3654 & 31u))) | ((_e3674 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3654) & 31u))));
let _e3684 = local_8.member_1[1u];
let _e3690 = f32(bitcast<i32>(((_e3681 >> bitcast<u32>((_e3684 & 31u))) & 255u)));
let _e3693 = local_8.member_1[2u];
let _e3700 = local_9[0u];
let _e3703 = (_e3690 + ((f32(bitcast<i32>(((_e3681 >> bitcast<u32>((_e3693 & 31u))) & 255u))) - _e3690) * _e3700));
let _e3705 = local_8.member[0u];
let _e3706 = ((_e3632 + _e3631) + _e3705);
let _e3708 = (_e3706 >> bitcast<u32>(2i));
let _e3711 = bitcast<u32>(((_e3706 & 3i) * 8i));
let _e3713 = select(_e3656, _e3708, (_e3708 < _e3656));
let _e3718 = global_2.member[bitcast<u32>(select(0i, _e3713, (_e3713 > 0i)))];
let _e3722 = (_e3708 + 1i);
let _e3724 = select(_e3656, _e3722, (_e3722 < _e3656));
let _e3729 = global_2.member[bitcast<u32>(select(0i, _e3724, (_e3724 > 0i)))];
let _e3736 = ((_e3718 >> bitcast<u32>((_e3711 & 31u))) | ((_e3729 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3711) & 31u))));
let _e3737 = local_8.member_1[1u];
let _e3743 = f32(bitcast<i32>(((_e3736 >> bitcast<u32>((_e3737 & 31u))) & 255u)));
let _e3744 = local_8.member_1[2u];
let _e3751 = local_9[0u];
let _e3756 = local_9[1u];
let _e3759 = (_e3703 + (((_e3743 + ((f32(bitcast<i32>(((_e3736 >> bitcast<u32>((_e3744 & 31u))) & 255u))) - _e3743) * _e3751)) - _e3703) * _e3756));
let _e3761 = local_8.member[0u];
let _e3762 = ((_e3633 + _e3630) + _e3761);
let _e3764 = (_e3762 >> bitcast<u32>(2i));
let _e3767 = bitcast<u32>(((_e3762 & 3i) * 8i));
let _e3769 = select(_e3656, _e3764, (_e3764 < _e3656));
let _e3774 = global_2.member[bitcast<u32>(select(0i, _e3769, (_e3769 > 0i)))];
let _e3778 = (_e3764 + 1i);
let _e3780 = select(_e3656, _e3778, (_e3778 < _e3656));
let _e3785 = global_2.member[bitcast<u32>(select(0i, _e3780, (_e3780 > 0i)))];
let _e3792 = ((_e3774 >> bitcast<u32>((_e3767 & 31u))) | ((_e3785 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3767) & 31u))));
let _e3793 = local_8.member_1[1u];
let _e3799 = f32(bitcast<i32>(((_e3792 >> bitcast<u32>((_e3793 & 31u))) & 255u)));
let _e3800 = local_8.member_1[2u];
let _e3807 = local_9[0u];
let _e3810 = (_e3799 + ((f32(bitcast<i32>(((_e3792 >> bitcast<u32>((_e3800 & 31u))) & 255u))) - _e3799) * _e3807));
let _e3812 = local_8.member[0u];
let _e3813 = ((_e3633 + _e3631) + _e3812);
let _e3815 = (_e3813 >> bitcast<u32>(2i));
let _e3818 = bitcast<u32>(((_e3813 & 3i) * 8i));
let _e3820 = select(_e3656, _e3815, (_e3815 < _e3656));
let _e3825 = global_2.member[bitcast<u32>(select(0i, _e3820, (_e3820 > 0i)))];
let _e3829 = (_e3815 + 1i);
let _e3831 = select(_e3656, _e3829, (_e3829 < _e3656));
let _e3836 = global_2.member[bitcast<u32>(select(0i, _e3831, (_e3831 > 0i)))];
let _e3843 = ((_e3825 >> bitcast<u32>((_e3818 & 31u))) | ((_e3836 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3818) & 31u))));
let _e3844 = local_8.member_1[1u];
let _e3850 = f32(bitcast<i32>(((_e3843 >> bitcast<u32>((_e3844 & 31u))) & 255u)));
let _e3851 = local_8.member_1[2u];
let _e3858 = local_9[0u];
let _e3862 = local_9[1u];
let _e3867 = local_9[2u];
let _e3874 = global_1.member.member_8.member_6;
let _e3878 = global_1.member.member_8.member_5;
let _e3880 = (((_e3759 + (((_e3810 + (((_e3850 + ((f32(bitcast<i32>(((_e3843 >> bitcast<u32>((_e3851 & 31u))) & 255u))) - _e3850) * _e3858)) - _e3810) * _e3862)) - _e3759) * _e3867)) - _e3874) * _e3878);
let _e3881 = -(1e9f);
let _e3883 = select(_e3881, _e3880, (_e3880 > _e3881));
let _e3885 = select(1e9f, _e3883, (_e3883 < 1e9f));
let _e3888 = global_1.member.member_1;
let _e3890 = ((_e3888 & 16u) == 0u);
if _e3890 {
phi_8980_ = type_7(1f, 1f, 1f);
} else {
let _e3894 = global_1.member.member_16.member;
let _e3905 = ((((_e3894.member.member * _e1129) + (_e3894.member.member_1 * _e1142)) + (_e3894.member.member_2 * _e1107)) + _e3894.member_1);
let _e3911 = ((((_e3894.member.member * _e1152) + (_e3894.member.member_1 * _e1157)) + (_e3894.member.member_2 * _e1146)) + _e3894.member_1);
let _e3913 = select(_e3911, _e3905, (_e3905 < _e3911));
let _e3915 = select(_e3911, _e3905, (_e3905 > _e3911));
let _e3917 = (_e3915 - _e3913);
let _e3920 = (-(_e3913) / select(1e-30f, _e3917, (_e3917 > 1e-30f)));
let _e3922 = select(0f, _e3920, (_e3920 > 0f));
let _e3928 = select(select(select(1f, _e3922, (_e3922 < 1f)), 1f, (_e3915 <= 0f)), 0f, (_e3913 > 0f));
let _e3933 = global_1.member.member_16.member_1;
let _e3934 = (_e3933 != 0u);
let _e3944 = global_1.member.member_17.member;
let _e3955 = ((((_e3944.member.member * _e1129) + (_e3944.member.member_1 * _e1142)) + (_e3944.member.member_2 * _e1107)) + _e3944.member_1);
let _e3961 = ((((_e3944.member.member * _e1152) + (_e3944.member.member_1 * _e1157)) + (_e3944.member.member_2 * _e1146)) + _e3944.member_1);
let _e3963 = select(_e3961, _e3955, (_e3955 < _e3961));
let _e3965 = select(_e3961, _e3955, (_e3955 > _e3961));
let _e3967 = (_e3965 - _e3963);
let _e3970 = (-(_e3963) / select(1e-30f, _e3967, (_e3967 > 1e-30f)));
let _e3972 = select(0f, _e3970, (_e3970 > 0f));
let _e3978 = select(select(select(1f, _e3972, (_e3972 < 1f)), 1f, (_e3965 <= 0f)), 0f, (_e3963 > 0f));
let _e3983 = global_1.member.member_17.member_1;
let _e3984 = (_e3983 != 0u);
let _e3994 = global_1.member.member_18.member;
let _e4005 = ((((_e3994.member.member * _e1129) + (_e3994.member.member_1 * _e1142)) + (_e3994.member.member_2 * _e1107)) + _e3994.member_1);
let _e4011 = ((((_e3994.member.member * _e1152) + (_e3994.member.member_1 * _e1157)) + (_e3994.member.member_2 * _e1146)) + _e3994.member_1);
let _e4013 = select(_e4011, _e4005, (_e4005 < _e4011));
let _e4015 = select(_e4011, _e4005, (_e4005 > _e4011));
let _e4017 = (_e4015 - _e4013);
let _e4020 = (-(_e4013) / select(1e-30f, _e4017, (_e4017 > 1e-30f)));
let _e4022 = select(0f, _e4020, (_e4020 > 0f));
let _e4028 = select(select(select(1f, _e4022, (_e4022 < 1f)), 1f, (_e4015 <= 0f)), 0f, (_e4013 > 0f));
let _e4033 = global_1.member.member_18.member_1;
let _e4034 = (_e4033 != 0u);
let _e4044 = global_1.member.member_19.member;
let _e4055 = ((((_e4044.member.member * _e1129) + (_e4044.member.member_1 * _e1142)) + (_e4044.member.member_2 * _e1107)) + _e4044.member_1);
let _e4061 = ((((_e4044.member.member * _e1152) + (_e4044.member.member_1 * _e1157)) + (_e4044.member.member_2 * _e1146)) + _e4044.member_1);
let _e4063 = select(_e4061, _e4055, (_e4055 < _e4061));
let _e4065 = select(_e4061, _e4055, (_e4055 > _e4061));
let _e4067 = (_e4065 - _e4063);
let _e4070 = (-(_e4063) / select(1e-30f, _e4067, (_e4067 > 1e-30f)));
let _e4072 = select(0f, _e4070, (_e4070 > 0f));
let _e4078 = select(select(select(1f, _e4072, (_e4072 < 1f)), 1f, (_e4065 <= 0f)), 0f, (_e4063 > 0f));
let _e4083 = global_1.member.member_19.member_1;
let _e4084 = (_e4083 != 0u);
phi_8980_ = type_7(((((1f * _e3928) * _e3978) * _e4028) * _e4078), ((((1f * select(1f, _e3928, _e3934)) * select(1f, _e3978, _e3984)) * select(1f, _e4028, _e4034)) * select(1f, _e4078, _e4084)), ((((1f * select(1f, 0f, (_e3934 && (_e3911 > 0f)))) * select(1f, 0f, (_e3984 && (_e3961 > 0f)))) * select(1f, 0f, (_e4034 && (_e4011 > 0f)))) * select(1f, 0f, (_e4084 && (_e4061 > 0f)))));
}
let _e4093 = phi_8980_;
let _e4094 = (_e1208 - _e1172);
let _e4098 = (bitcast<f32>((bitcast<u32>(_e4094) & 2147483647u)) < 1e-12f);
let _e4100 = (1f / select(_e4094, 1f, _e4098));
let _e4101 = (-0.5f - _e1172);
let _e4102 = (_e4101 * _e4100);
let _e4104 = ((_e3490 - _e1172) * _e4100);
let _e4110 = select(_e4104, _e4102, (_e4102 < _e4104));
let _e4112 = select(0f, _e4110, (_e4110 > 0f));
let _e4115 = select(select(1f, _e4112, (_e4112 < 1f)), select(2f, 0f, ((_e1172 >= -0.5f) && (_e1172 <= _e3490))), _e4098);
let _e4117 = select(_e4104, _e4102, (_e4102 > _e4104));
let _e4119 = select(0f, _e4117, (_e4117 > 0f));
let _e4122 = select(select(1f, _e4119, (_e4119 < 1f)), 1f, _e4098);
let _e4123 = (_e1214 - _e1187);
let _e4127 = (bitcast<f32>((bitcast<u32>(_e4123) & 2147483647u)) < 1e-12f);
let _e4129 = (1f / select(_e4123, 1f, _e4127));
let _e4130 = (-0.5f - _e1187);
let _e4131 = (_e4130 * _e4129);
let _e4133 = ((_e3500 - _e1187) * _e4129);
let _e4139 = select(_e4133, _e4131, (_e4131 < _e4133));
let _e4141 = select(0f, _e4139, (_e4139 > 0f));
let _e4144 = select(select(1f, _e4141, (_e4141 < 1f)), select(2f, 0f, ((_e1187 >= -0.5f) && (_e1187 <= _e3500))), _e4127);
let _e4146 = select(_e4133, _e4131, (_e4131 > _e4133));
let _e4148 = select(0f, _e4146, (_e4146 > 0f));
let _e4151 = select(select(1f, _e4148, (_e4148 < 1f)), 1f, _e4127);
let _e4152 = (_e1220 - _e1202);
let _e4156 = (bitcast<f32>((bitcast<u32>(_e4152) & 2147483647u)) < 1e-12f);
let _e4158 = (1f / select(_e4152, 1f, _e4156));
let _e4159 = (-0.5f - _e1202);
let _e4160 = (_e4159 * _e4158);
let _e4162 = ((_e3510 - _e1202) * _e4158);
let _e4168 = select(_e4162, _e4160, (_e4160 < _e4162));
let _e4170 = select(0f, _e4168, (_e4168 > 0f));
let _e4173 = select(select(1f, _e4170, (_e4170 < 1f)), select(2f, 0f, ((_e1202 >= -0.5f) && (_e1202 <= _e3510))), _e4156);
let _e4175 = select(_e4162, _e4160, (_e4160 > _e4162));
let _e4177 = select(0f, _e4175, (_e4175 > 0f));
let _e4180 = select(select(1f, _e4177, (_e4177 < 1f)), 1f, _e4156);
let _e4182 = select(_e4151, _e4122, (_e4122 < _e4151));
let _e4186 = select(_e4144, _e4115, (_e4115 > _e4144));
let _e4189 = (select(_e4180, _e4182, (_e4182 < _e4180)) - select(_e4173, _e4186, (_e4186 > _e4173)));
let _e4192 = (_e1152 - _e1129);
let _e4193 = (_e1157 - _e1142);
let _e4194 = (_e1146 - _e1107);
let _e4199 = (((_e4192 * _e4192) + (_e4193 * _e4193)) + (_e4194 * _e4194));
let _e4207 = global_1.member.member_7.member_3;
let _e4208 = ((sqrt(select(0f, _e4199, (_e4199 > 0f))) * select(0f, _e4189, (_e4189 > 0f))) * _e4207);
if (((_e175.member_2 == 3u) || (_e175.member_2 == 4u)) || _e1222) {
local_7 = _e3885;
let _e4214 = local_7;
let _e4216 = (bitcast<i32>(_e165) - 1i);
let _e4218 = select(_e4216, 263171i, (263171i < _e4216));
let _e4223 = global_3.member[bitcast<u32>(select(0i, _e4218, (_e4218 > 0i)))];
let _e4224 = bitcast<f32>(_e4223);
let _e4226 = select(_e4216, 263172i, (263172i < _e4216));
let _e4231 = global_3.member[bitcast<u32>(select(0i, _e4226, (_e4226 > 0i)))];
let _e4232 = bitcast<f32>(_e4231);
let _e4234 = select(_e4216, 263173i, (263173i < _e4216));
let _e4239 = global_3.member[bitcast<u32>(select(0i, _e4234, (_e4234 > 0i)))];
let _e4240 = bitcast<f32>(_e4239);
let _e4242 = ((_e4214 - _e4224) * _e4232);
let _e4244 = select(0f, _e4242, (_e4242 > 0f));
let _e4247 = local_7;
let _e4249 = select(_e4216, 263174i, (263174i < _e4216));
let _e4254 = global_3.member[bitcast<u32>(select(0i, _e4249, (_e4249 > 0i)))];
let _e4255 = bitcast<f32>(_e4254);
let _e4257 = select(_e4216, 263175i, (263175i < _e4216));
let _e4262 = global_3.member[bitcast<u32>(select(0i, _e4257, (_e4257 > 0i)))];
let _e4263 = bitcast<f32>(_e4262);
let _e4265 = select(_e4216, 263176i, (263176i < _e4216));
let _e4270 = global_3.member[bitcast<u32>(select(0i, _e4265, (_e4265 > 0i)))];
let _e4271 = bitcast<f32>(_e4270);
let _e4273 = ((_e4247 - _e4255) * _e4263);
let _e4275 = select(0f, _e4273, (_e4273 > 0f));
let _e4279 = local_7;
let _e4281 = select(_e4216, 263177i, (263177i < _e4216));
let _e4286 = global_3.member[bitcast<u32>(select(0i, _e4281, (_e4281 > 0i)))];
let _e4287 = bitcast<f32>(_e4286);
let _e4289 = select(_e4216, 263178i, (263178i < _e4216));
let _e4294 = global_3.member[bitcast<u32>(select(0i, _e4289, (_e4289 > 0i)))];
let _e4295 = bitcast<f32>(_e4294);
let _e4297 = select(_e4216, 263179i, (263179i < _e4216));
let _e4302 = global_3.member[bitcast<u32>(select(0i, _e4297, (_e4297 > 0i)))];
let _e4303 = bitcast<f32>(_e4302);
let _e4305 = ((_e4279 - _e4287) * _e4295);
let _e4307 = select(0f, _e4305, (_e4305 > 0f));
let _e4310 = local_7;
let _e4312 = select(_e4216, 263180i, (263180i < _e4216));
let _e4317 = global_3.member[bitcast<u32>(select(0i, _e4312, (_e4312 > 0i)))];
let _e4318 = bitcast<f32>(_e4317);
let _e4320 = select(_e4216, 263181i, (263181i < _e4216));
let _e4325 = global_3.member[bitcast<u32>(select(0i, _e4320, (_e4320 > 0i)))];
let _e4326 = bitcast<f32>(_e4325);
let _e4328 = select(_e4216, 263182i, (263182i < _e4216));
let _e4333 = global_3.member[bitcast<u32>(select(0i, _e4328, (_e4328 > 0i)))];
let _e4334 = bitcast<f32>(_e4333);
let _e4336 = ((_e4310 - _e4318) * _e4326);
let _e4338 = select(0f, _e4336, (_e4336 > 0f));
let _e4343 = local_7;
let _e4345 = select(_e4216, 263183i, (263183i < _e4216));
let _e4350 = global_3.member[bitcast<u32>(select(0i, _e4345, (_e4345 > 0i)))];
let _e4351 = bitcast<f32>(_e4350);
let _e4353 = select(_e4216, 263184i, (263184i < _e4216));
let _e4358 = global_3.member[bitcast<u32>(select(0i, _e4353, (_e4353 > 0i)))];
let _e4359 = bitcast<f32>(_e4358);
let _e4361 = select(_e4216, 263185i, (263185i < _e4216));
let _e4366 = global_3.member[bitcast<u32>(select(0i, _e4361, (_e4361 > 0i)))];
let _e4367 = bitcast<f32>(_e4366);
let _e4369 = ((_e4343 - _e4351) * _e4359);
let _e4371 = select(0f, _e4369, (_e4369 > 0f));
let _e4374 = local_7;
let _e4376 = select(_e4216, 263186i, (263186i < _e4216));
let _e4381 = global_3.member[bitcast<u32>(select(0i, _e4376, (_e4376 > 0i)))];
let _e4382 = bitcast<f32>(_e4381);
let _e4384 = select(_e4216, 263187i, (263187i < _e4216));
let _e4389 = global_3.member[bitcast<u32>(select(0i, _e4384, (_e4384 > 0i)))];
let _e4390 = bitcast<f32>(_e4389);
let _e4392 = select(_e4216, 263188i, (263188i < _e4216));
let _e4397 = global_3.member[bitcast<u32>(select(0i, _e4392, (_e4392 > 0i)))];
let _e4398 = bitcast<f32>(_e4397);
let _e4400 = ((_e4374 - _e4382) * _e4390);
let _e4402 = select(0f, _e4400, (_e4400 > 0f));
let _e4406 = local_7;
let _e4408 = select(_e4216, 263189i, (263189i < _e4216));
let _e4413 = global_3.member[bitcast<u32>(select(0i, _e4408, (_e4408 > 0i)))];
let _e4414 = bitcast<f32>(_e4413);
let _e4416 = select(_e4216, 263190i, (263190i < _e4216));
let _e4421 = global_3.member[bitcast<u32>(select(0i, _e4416, (_e4416 > 0i)))];
let _e4422 = bitcast<f32>(_e4421);
let _e4424 = select(_e4216, 263191i, (263191i < _e4216));
let _e4429 = global_3.member[bitcast<u32>(select(0i, _e4424, (_e4424 > 0i)))];
let _e4430 = bitcast<f32>(_e4429);
let _e4432 = ((_e4406 - _e4414) * _e4422);
let _e4434 = select(0f, _e4432, (_e4432 > 0f));
let _e4437 = local_7;
let _e4439 = select(_e4216, 263192i, (263192i < _e4216));
let _e4444 = global_3.member[bitcast<u32>(select(0i, _e4439, (_e4439 > 0i)))];
let _e4445 = bitcast<f32>(_e4444);
let _e4447 = select(_e4216, 263193i, (263193i < _e4216));
let _e4452 = global_3.member[bitcast<u32>(select(0i, _e4447, (_e4447 > 0i)))];
let _e4453 = bitcast<f32>(_e4452);
let _e4455 = select(_e4216, 263194i, (263194i < _e4216));
let _e4460 = global_3.member[bitcast<u32>(select(0i, _e4455, (_e4455 > 0i)))];
let _e4461 = bitcast<f32>(_e4460);
let _e4463 = ((_e4437 - _e4445) * _e4453);
let _e4465 = select(0f, _e4463, (_e4463 > 0f));
let _e4470 = (((select(_e4240, _e4244, (_e4244 < _e4240)) + select(_e4271, _e4275, (_e4275 < _e4271))) + (select(_e4303, _e4307, (_e4307 < _e4303)) + select(_e4334, _e4338, (_e4338 < _e4334)))) + ((select(_e4367, _e4371, (_e4371 < _e4367)) + select(_e4398, _e4402, (_e4402 < _e4398))) + (select(_e4430, _e4434, (_e4434 < _e4430)) + select(_e4461, _e4465, (_e4465 < _e4461)))));
local_6 = _e3484.member;
let _e4471 = local_6;
let _e4473 = ((_e4471 - _e4224) * _e4232);
let _e4475 = select(0f, _e4473, (_e4473 > 0f));
let _e4478 = local_6;
let _e4480 = ((_e4478 - _e4255) * _e4263);
let _e4482 = select(0f, _e4480, (_e4480 > 0f));
let _e4486 = local_6;
let _e4488 = ((_e4486 - _e4287) * _e4295);
let _e4490 = select(0f, _e4488, (_e4488 > 0f));
let _e4493 = local_6;
let _e4495 = ((_e4493 - _e4318) * _e4326);
let _e4497 = select(0f, _e4495, (_e4495 > 0f));
let _e4502 = local_6;
let _e4504 = ((_e4502 - _e4351) * _e4359);
let _e4506 = select(0f, _e4504, (_e4504 > 0f));
let _e4509 = local_6;
let _e4511 = ((_e4509 - _e4382) * _e4390);
let _e4513 = select(0f, _e4511, (_e4511 > 0f));
let _e4517 = local_6;
let _e4519 = ((_e4517 - _e4414) * _e4422);
let _e4521 = select(0f, _e4519, (_e4519 > 0f));
let _e4524 = local_6;
let _e4526 = ((_e4524 - _e4445) * _e4453);
let _e4528 = select(0f, _e4526, (_e4526 > 0f));
let _e4533 = (((select(_e4240, _e4475, (_e4475 < _e4240)) + select(_e4271, _e4482, (_e4482 < _e4271))) + (select(_e4303, _e4490, (_e4490 < _e4303)) + select(_e4334, _e4497, (_e4497 < _e4334)))) + ((select(_e4367, _e4506, (_e4506 < _e4367)) + select(_e4398, _e4513, (_e4513 < _e4398))) + (select(_e4430, _e4521, (_e4521 < _e4430)) + select(_e4461, _e4528, (_e4528 < _e4461)))));
let _e4534 = (255f - 1f);
let _e4536 = select(0f, _e4470, (_e4470 > 0f));
let _e4538 = select(_e4534, _e4536, (_e4536 < _e4534));
let _e4545 = select(0i, select(select(i32(_e4538), i32(-2147483648), (_e4538 < -2147483600f)), 2147483647i, (_e4538 > 2147483500f)), (_e4538 == _e4538));
let _e4549 = (_e4545 - select(0i, 1i, (_e4538 < f32(_e4545))));
let _e4551 = select(0f, _e4533, (_e4533 > 0f));
let _e4553 = select(_e4534, _e4551, (_e4551 < _e4534));
let _e4560 = select(0i, select(select(i32(_e4553), i32(-2147483648), (_e4553 < -2147483600f)), 2147483647i, (_e4553 > 2147483500f)), (_e4553 == _e4553));
let _e4564 = (_e4560 - select(0i, 1i, (_e4553 < f32(_e4560))));
let _e4566 = select(_e4216, 263195i, (263195i < _e4216));
let _e4572 = global_3.member[bitcast<u32>(select(0i, _e4566, (_e4566 > 0i)))];
let _e4573 = bitcast<f32>(_e4572);
let _e4575 = select(_e4216, 263196i, (263196i < _e4216));
let _e4581 = global_3.member[bitcast<u32>(select(0i, _e4575, (_e4575 > 0i)))];
let _e4582 = bitcast<f32>(_e4581);
let _e4583 = (_e3484.member - _e3885);
let _e4589 = (1f / select(_e4583, 1f, (bitcast<f32>((bitcast<u32>(_e4583) & 2147483647u)) < 1e-20f)));
let _e4595 = ((select(_e4573, _e3484.member, (_e3484.member < _e4573)) - select(_e4573, _e3885, (_e3885 < _e4573))) * _e4589);
let _e4601 = ((select(_e4582, _e3484.member, (_e3484.member > _e4582)) - select(_e4582, _e3885, (_e3885 > _e4582))) * _e4589);
let _e4604 = (((_e4549 * 256i) + _e4564) * 4i);
let _e4608 = (_e4533 - f32(_e4564));
let _e4612 = select(_e4216, _e4604, (_e4604 < _e4216));
let _e4618 = global_3.member[bitcast<u32>(select(0i, _e4612, (_e4612 > 0i)))];
let _e4619 = (_e4604 + 4i);
let _e4621 = select(_e4216, _e4619, (_e4619 < _e4216));
let _e4627 = global_3.member[bitcast<u32>(select(0i, _e4621, (_e4621 > 0i)))];
let _e4628 = (_e4604 + 1024i);
let _e4630 = select(_e4216, _e4628, (_e4628 < _e4216));
let _e4636 = global_3.member[bitcast<u32>(select(0i, _e4630, (_e4630 > 0i)))];
let _e4637 = (_e4604 + 1028i);
let _e4639 = select(_e4216, _e4637, (_e4637 < _e4216));
let _e4645 = global_3.member[bitcast<u32>(select(0i, _e4639, (_e4639 > 0i)))];
let _e4647 = select(_e4216, 0i, (0i < _e4216));
let _e4653 = global_3.member[bitcast<u32>(select(0i, _e4647, (_e4647 > 0i)))];
let _e4655 = select(_e4216, 262140i, (262140i < _e4216));
let _e4661 = global_3.member[bitcast<u32>(select(0i, _e4655, (_e4655 > 0i)))];
let _e4666 = (bitcast<f32>(((_e4618 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4674 = (_e4666 + (((bitcast<f32>(((_e4627 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4666) * _e4608));
let _e4679 = (bitcast<f32>(((_e4636 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4705 = (((_e4674 + (((_e4679 + (((bitcast<f32>(((_e4645 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4679) * _e4608)) - _e4674) * (_e4470 - f32(_e4549)))) * (1f - (_e4595 + _e4601))) + (((bitcast<f32>(((_e4653 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4595) + ((bitcast<f32>(((_e4661 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4601)));
let _e4709 = -((_e4705 * (_e4208 * _e4093.member)));
let _e4711 = select(-87f, _e4709, (_e4709 > -87f));
let _e4713 = select(88f, _e4711, (_e4711 < 88f));
let _e4715 = ((_e4713 * 1.442695f) + 0.5f);
let _e4717 = select(-127f, _e4715, (_e4715 > -127f));
let _e4719 = select(128f, _e4717, (_e4717 < 128f));
let _e4726 = select(0i, select(select(i32(_e4719), i32(-2147483648), (_e4719 < -2147483600f)), 2147483647i, (_e4719 > 2147483500f)), (_e4719 == _e4719));
let _e4730 = (_e4726 - select(0i, 1i, (_e4719 < f32(_e4726))));
let _e4731 = f32(_e4730);
let _e4735 = ((_e4713 - (_e4731 * 0.6933594f)) - (_e4731 * -2.1219444e-4f));
let _e4755 = ((1f + (_e4735 * (1f + (_e4735 * (0.5f + (_e4735 * (0.16666667f + (_e4735 * (0.041666668f + (_e4735 * (0.008333334f + (_e4735 * (0.001388889f + (_e4735 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4730 + 127i)) << bitcast<u32>(23i))));
let _e4756 = (1f - _e4755);
phi_12708_ = type_35(_e4755, _e4756, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e4756 / select(1e-12f, _e4705, (_e4705 > 1e-12f))))));
} else {
local_5 = _e3885;
let _e4764 = local_5;
let _e4766 = (bitcast<i32>(_e165) - 1i);
let _e4768 = select(_e4766, 263171i, (263171i < _e4766));
let _e4773 = global_3.member[bitcast<u32>(select(0i, _e4768, (_e4768 > 0i)))];
let _e4774 = bitcast<f32>(_e4773);
let _e4776 = select(_e4766, 263172i, (263172i < _e4766));
let _e4781 = global_3.member[bitcast<u32>(select(0i, _e4776, (_e4776 > 0i)))];
let _e4782 = bitcast<f32>(_e4781);
let _e4784 = select(_e4766, 263173i, (263173i < _e4766));
let _e4789 = global_3.member[bitcast<u32>(select(0i, _e4784, (_e4784 > 0i)))];
let _e4790 = bitcast<f32>(_e4789);
let _e4792 = ((_e4764 - _e4774) * _e4782);
let _e4794 = select(0f, _e4792, (_e4792 > 0f));
let _e4797 = local_5;
let _e4799 = select(_e4766, 263174i, (263174i < _e4766));
let _e4804 = global_3.member[bitcast<u32>(select(0i, _e4799, (_e4799 > 0i)))];
let _e4805 = bitcast<f32>(_e4804);
let _e4807 = select(_e4766, 263175i, (263175i < _e4766));
let _e4812 = global_3.member[bitcast<u32>(select(0i, _e4807, (_e4807 > 0i)))];
let _e4813 = bitcast<f32>(_e4812);
let _e4815 = select(_e4766, 263176i, (263176i < _e4766));
let _e4820 = global_3.member[bitcast<u32>(select(0i, _e4815, (_e4815 > 0i)))];
let _e4821 = bitcast<f32>(_e4820);
let _e4823 = ((_e4797 - _e4805) * _e4813);
let _e4825 = select(0f, _e4823, (_e4823 > 0f));
let _e4829 = local_5;
let _e4831 = select(_e4766, 263177i, (263177i < _e4766));
let _e4836 = global_3.member[bitcast<u32>(select(0i, _e4831, (_e4831 > 0i)))];
let _e4837 = bitcast<f32>(_e4836);
let _e4839 = select(_e4766, 263178i, (263178i < _e4766));
let _e4844 = global_3.member[bitcast<u32>(select(0i, _e4839, (_e4839 > 0i)))];
let _e4845 = bitcast<f32>(_e4844);
let _e4847 = select(_e4766, 263179i, (263179i < _e4766));
let _e4852 = global_3.member[bitcast<u32>(select(0i, _e4847, (_e4847 > 0i)))];
let _e4853 = bitcast<f32>(_e4852);
let _e4855 = ((_e4829 - _e4837) * _e4845);
let _e4857 = select(0f, _e4855, (_e4855 > 0f));
let _e4860 = local_5;
let _e4862 = select(_e4766, 263180i, (263180i < _e4766));
let _e4867 = global_3.member[bitcast<u32>(select(0i, _e4862, (_e4862 > 0i)))];
let _e4868 = bitcast<f32>(_e4867);
let _e4870 = select(_e4766, 263181i, (263181i < _e4766));
let _e4875 = global_3.member[bitcast<u32>(select(0i, _e4870, (_e4870 > 0i)))];
let _e4876 = bitcast<f32>(_e4875);
let _e4878 = select(_e4766, 263182i, (263182i < _e4766));
let _e4883 = global_3.member[bitcast<u32>(select(0i, _e4878, (_e4878 > 0i)))];
let _e4884 = bitcast<f32>(_e4883);
let _e4886 = ((_e4860 - _e4868) * _e4876);
let _e4888 = select(0f, _e4886, (_e4886 > 0f));
let _e4893 = local_5;
let _e4895 = select(_e4766, 263183i, (263183i < _e4766));
let _e4900 = global_3.member[bitcast<u32>(select(0i, _e4895, (_e4895 > 0i)))];
let _e4901 = bitcast<f32>(_e4900);
let _e4903 = select(_e4766, 263184i, (263184i < _e4766));
let _e4908 = global_3.member[bitcast<u32>(select(0i, _e4903, (_e4903 > 0i)))];
let _e4909 = bitcast<f32>(_e4908);
let _e4911 = select(_e4766, 263185i, (263185i < _e4766));
let _e4916 = global_3.member[bitcast<u32>(select(0i, _e4911, (_e4911 > 0i)))];
let _e4917 = bitcast<f32>(_e4916);
let _e4919 = ((_e4893 - _e4901) * _e4909);
let _e4921 = select(0f, _e4919, (_e4919 > 0f));
let _e4924 = local_5;
let _e4926 = select(_e4766, 263186i, (263186i < _e4766));
let _e4931 = global_3.member[bitcast<u32>(select(0i, _e4926, (_e4926 > 0i)))];
let _e4932 = bitcast<f32>(_e4931);
let _e4934 = select(_e4766, 263187i, (263187i < _e4766));
let _e4939 = global_3.member[bitcast<u32>(select(0i, _e4934, (_e4934 > 0i)))];
let _e4940 = bitcast<f32>(_e4939);
let _e4942 = select(_e4766, 263188i, (263188i < _e4766));
let _e4947 = global_3.member[bitcast<u32>(select(0i, _e4942, (_e4942 > 0i)))];
let _e4948 = bitcast<f32>(_e4947);
let _e4950 = ((_e4924 - _e4932) * _e4940);
let _e4952 = select(0f, _e4950, (_e4950 > 0f));
let _e4956 = local_5;
let _e4958 = select(_e4766, 263189i, (263189i < _e4766));
let _e4963 = global_3.member[bitcast<u32>(select(0i, _e4958, (_e4958 > 0i)))];
let _e4964 = bitcast<f32>(_e4963);
let _e4966 = select(_e4766, 263190i, (263190i < _e4766));
let _e4971 = global_3.member[bitcast<u32>(select(0i, _e4966, (_e4966 > 0i)))];
let _e4972 = bitcast<f32>(_e4971);
let _e4974 = select(_e4766, 263191i, (263191i < _e4766));
let _e4979 = global_3.member[bitcast<u32>(select(0i, _e4974, (_e4974 > 0i)))];
let _e4980 = bitcast<f32>(_e4979);
let _e4982 = ((_e4956 - _e4964) * _e4972);
let _e4984 = select(0f, _e4982, (_e4982 > 0f));
let _e4987 = local_5;
let _e4989 = select(_e4766, 263192i, (263192i < _e4766));
let _e4994 = global_3.member[bitcast<u32>(select(0i, _e4989, (_e4989 > 0i)))];
let _e4995 = bitcast<f32>(_e4994);
let _e4997 = select(_e4766, 263193i, (263193i < _e4766));
let _e5002 = global_3.member[bitcast<u32>(select(0i, _e4997, (_e4997 > 0i)))];
let _e5003 = bitcast<f32>(_e5002);
let _e5005 = select(_e4766, 263194i, (263194i < _e4766));
let _e5010 = global_3.member[bitcast<u32>(select(0i, _e5005, (_e5005 > 0i)))];
let _e5011 = bitcast<f32>(_e5010);
let _e5013 = ((_e4987 - _e4995) * _e5003);
let _e5015 = select(0f, _e5013, (_e5013 > 0f));
let _e5020 = (((select(_e4790, _e4794, (_e4794 < _e4790)) + select(_e4821, _e4825, (_e4825 < _e4821))) + (select(_e4853, _e4857, (_e4857 < _e4853)) + select(_e4884, _e4888, (_e4888 < _e4884)))) + ((select(_e4917, _e4921, (_e4921 < _e4917)) + select(_e4948, _e4952, (_e4952 < _e4948))) + (select(_e4980, _e4984, (_e4984 < _e4980)) + select(_e5011, _e5015, (_e5015 < _e5011)))));
local_4 = _e3484.member;
let _e5021 = local_4;
let _e5023 = ((_e5021 - _e4774) * _e4782);
let _e5025 = select(0f, _e5023, (_e5023 > 0f));
let _e5028 = local_4;
let _e5030 = ((_e5028 - _e4805) * _e4813);
let _e5032 = select(0f, _e5030, (_e5030 > 0f));
let _e5036 = local_4;
let _e5038 = ((_e5036 - _e4837) * _e4845);
let _e5040 = select(0f, _e5038, (_e5038 > 0f));
let _e5043 = local_4;
let _e5045 = ((_e5043 - _e4868) * _e4876);
let _e5047 = select(0f, _e5045, (_e5045 > 0f));
let _e5052 = local_4;
let _e5054 = ((_e5052 - _e4901) * _e4909);
let _e5056 = select(0f, _e5054, (_e5054 > 0f));
let _e5059 = local_4;
let _e5061 = ((_e5059 - _e4932) * _e4940);
let _e5063 = select(0f, _e5061, (_e5061 > 0f));
let _e5067 = local_4;
let _e5069 = ((_e5067 - _e4964) * _e4972);
let _e5071 = select(0f, _e5069, (_e5069 > 0f));
let _e5074 = local_4;
let _e5076 = ((_e5074 - _e4995) * _e5003);
let _e5078 = select(0f, _e5076, (_e5076 > 0f));
let _e5083 = (((select(_e4790, _e5025, (_e5025 < _e4790)) + select(_e4821, _e5032, (_e5032 < _e4821))) + (select(_e4853, _e5040, (_e5040 < _e4853)) + select(_e4884, _e5047, (_e5047 < _e4884)))) + ((select(_e4917, _e5056, (_e5056 < _e4917)) + select(_e4948, _e5063, (_e5063 < _e4948))) + (select(_e4980, _e5071, (_e5071 < _e4980)) + select(_e5011, _e5078, (_e5078 < _e5011)))));
let _e5084 = (255f - 1f);
let _e5086 = select(0f, _e5020, (_e5020 > 0f));
let _e5088 = select(_e5084, _e5086, (_e5086 < _e5084));
let _e5095 = select(0i, select(select(i32(_e5088), i32(-2147483648), (_e5088 < -2147483600f)), 2147483647i, (_e5088 > 2147483500f)), (_e5088 == _e5088));
let _e5099 = (_e5095 - select(0i, 1i, (_e5088 < f32(_e5095))));
let _e5101 = select(0f, _e5083, (_e5083 > 0f));
let _e5103 = select(_e5084, _e5101, (_e5101 < _e5084));
let _e5110 = select(0i, select(select(i32(_e5103), i32(-2147483648), (_e5103 < -2147483600f)), 2147483647i, (_e5103 > 2147483500f)), (_e5103 == _e5103));
let _e5114 = (_e5110 - select(0i, 1i, (_e5103 < f32(_e5110))));
let _e5116 = select(_e4766, 263195i, (263195i < _e4766));
let _e5122 = global_3.member[bitcast<u32>(select(0i, _e5116, (_e5116 > 0i)))];
let _e5123 = bitcast<f32>(_e5122);
let _e5125 = select(_e4766, 263196i, (263196i < _e4766));
let _e5131 = global_3.member[bitcast<u32>(select(0i, _e5125, (_e5125 > 0i)))];
let _e5132 = bitcast<f32>(_e5131);
let _e5133 = (_e3484.member - _e3885);
let _e5139 = (1f / select(_e5133, 1f, (bitcast<f32>((bitcast<u32>(_e5133) & 2147483647u)) < 1e-20f)));
let _e5145 = ((select(_e5123, _e3484.member, (_e3484.member < _e5123)) - select(_e5123, _e3885, (_e3885 < _e5123))) * _e5139);
let _e5151 = ((select(_e5132, _e3484.member, (_e3484.member > _e5132)) - select(_e5132, _e3885, (_e3885 > _e5132))) * _e5139);
let _e5154 = (((_e5099 * 256i) + _e5114) * 4i);
let _e5156 = (_e5020 - f32(_e5099));
let _e5158 = (_e5083 - f32(_e5114));
let _e5160 = (1f - (_e5145 + _e5151));
let _e5162 = select(_e4766, _e5154, (_e5154 < _e4766));
let _e5168 = global_3.member[bitcast<u32>(select(0i, _e5162, (_e5162 > 0i)))];
let _e5169 = (_e5154 + 4i);
let _e5171 = select(_e4766, _e5169, (_e5169 < _e4766));
let _e5177 = global_3.member[bitcast<u32>(select(0i, _e5171, (_e5171 > 0i)))];
let _e5178 = (_e5154 + 1024i);
let _e5180 = select(_e4766, _e5178, (_e5178 < _e4766));
let _e5186 = global_3.member[bitcast<u32>(select(0i, _e5180, (_e5180 > 0i)))];
let _e5187 = (_e5154 + 1028i);
let _e5189 = select(_e4766, _e5187, (_e5187 < _e4766));
let _e5195 = global_3.member[bitcast<u32>(select(0i, _e5189, (_e5189 > 0i)))];
let _e5197 = select(_e4766, 0i, (0i < _e4766));
let _e5203 = global_3.member[bitcast<u32>(select(0i, _e5197, (_e5197 > 0i)))];
let _e5205 = select(_e4766, 262140i, (262140i < _e4766));
let _e5211 = global_3.member[bitcast<u32>(select(0i, _e5205, (_e5205 > 0i)))];
let _e5216 = (bitcast<f32>(((_e5168 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5224 = (_e5216 + (((bitcast<f32>(((_e5177 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5216) * _e5158));
let _e5229 = (bitcast<f32>(((_e5186 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5255 = (((_e5224 + (((_e5229 + (((bitcast<f32>(((_e5195 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5229) * _e5158)) - _e5224) * _e5156)) * _e5160) + (((bitcast<f32>(((_e5203 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5145) + ((bitcast<f32>(((_e5211 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5151)));
let _e5272 = (bitcast<f32>((((_e5168 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5280 = (_e5272 + (((bitcast<f32>((((_e5177 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5272) * _e5158));
let _e5285 = (bitcast<f32>((((_e5186 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5312 = (_e5154 + 1i);
let _e5314 = select(_e4766, _e5312, (_e5312 < _e4766));
let _e5320 = global_3.member[bitcast<u32>(select(0i, _e5314, (_e5314 > 0i)))];
let _e5321 = (_e5154 + 5i);
let _e5323 = select(_e4766, _e5321, (_e5321 < _e4766));
let _e5329 = global_3.member[bitcast<u32>(select(0i, _e5323, (_e5323 > 0i)))];
let _e5330 = (_e5154 + 1025i);
let _e5332 = select(_e4766, _e5330, (_e5330 < _e4766));
let _e5338 = global_3.member[bitcast<u32>(select(0i, _e5332, (_e5332 > 0i)))];
let _e5339 = (_e5154 + 1029i);
let _e5341 = select(_e4766, _e5339, (_e5339 < _e4766));
let _e5347 = global_3.member[bitcast<u32>(select(0i, _e5341, (_e5341 > 0i)))];
let _e5349 = select(_e4766, 1i, (1i < _e4766));
let _e5355 = global_3.member[bitcast<u32>(select(0i, _e5349, (_e5349 > 0i)))];
let _e5357 = select(_e4766, 262141i, (262141i < _e4766));
let _e5363 = global_3.member[bitcast<u32>(select(0i, _e5357, (_e5357 > 0i)))];
let _e5368 = (bitcast<f32>(((_e5320 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5376 = (_e5368 + (((bitcast<f32>(((_e5329 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5368) * _e5158));
let _e5381 = (bitcast<f32>(((_e5338 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5424 = (bitcast<f32>((((_e5320 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5432 = (_e5424 + (((bitcast<f32>((((_e5329 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5424) * _e5158));
let _e5437 = (bitcast<f32>((((_e5338 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5467 = (_e4208 * _e4093.member_1);
let _e5469 = -(((((_e5280 + (((_e5285 + (((bitcast<f32>((((_e5195 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5285) * _e5158)) - _e5280) * _e5156)) * _e5160) + (((bitcast<f32>((((_e5203 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5145) + ((bitcast<f32>((((_e5211 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5151))) * _e5467));
let _e5471 = select(-87f, _e5469, (_e5469 > -87f));
let _e5473 = select(88f, _e5471, (_e5471 < 88f));
let _e5475 = ((_e5473 * 1.442695f) + 0.5f);
let _e5477 = select(-127f, _e5475, (_e5475 > -127f));
let _e5479 = select(128f, _e5477, (_e5477 < 128f));
let _e5486 = select(0i, select(select(i32(_e5479), i32(-2147483648), (_e5479 < -2147483600f)), 2147483647i, (_e5479 > 2147483500f)), (_e5479 == _e5479));
let _e5490 = (_e5486 - select(0i, 1i, (_e5479 < f32(_e5486))));
let _e5491 = f32(_e5490);
let _e5495 = ((_e5473 - (_e5491 * 0.6933594f)) - (_e5491 * -2.1219444e-4f));
let _e5517 = -(((((_e5376 + (((_e5381 + (((bitcast<f32>(((_e5347 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5381) * _e5158)) - _e5376) * _e5156)) * _e5160) + (((bitcast<f32>(((_e5355 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5145) + ((bitcast<f32>(((_e5363 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5151))) * _e5467));
let _e5519 = select(-87f, _e5517, (_e5517 > -87f));
let _e5521 = select(88f, _e5519, (_e5519 < 88f));
let _e5523 = ((_e5521 * 1.442695f) + 0.5f);
let _e5525 = select(-127f, _e5523, (_e5523 > -127f));
let _e5527 = select(128f, _e5525, (_e5525 < 128f));
let _e5534 = select(0i, select(select(i32(_e5527), i32(-2147483648), (_e5527 < -2147483600f)), 2147483647i, (_e5527 > 2147483500f)), (_e5527 == _e5527));
let _e5538 = (_e5534 - select(0i, 1i, (_e5527 < f32(_e5534))));
let _e5539 = f32(_e5538);
let _e5543 = ((_e5521 - (_e5539 * 0.6933594f)) - (_e5539 * -2.1219444e-4f));
let _e5565 = -(((((_e5432 + (((_e5437 + (((bitcast<f32>((((_e5347 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5437) * _e5158)) - _e5432) * _e5156)) * _e5160) + (((bitcast<f32>((((_e5355 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5145) + ((bitcast<f32>((((_e5363 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5151))) * _e5467));
let _e5567 = select(-87f, _e5565, (_e5565 > -87f));
let _e5569 = select(88f, _e5567, (_e5567 < 88f));
let _e5571 = ((_e5569 * 1.442695f) + 0.5f);
let _e5573 = select(-127f, _e5571, (_e5571 > -127f));
let _e5575 = select(128f, _e5573, (_e5573 < 128f));
let _e5582 = select(0i, select(select(i32(_e5575), i32(-2147483648), (_e5575 < -2147483600f)), 2147483647i, (_e5575 > 2147483500f)), (_e5575 == _e5575));
let _e5586 = (_e5582 - select(0i, 1i, (_e5575 < f32(_e5582))));
let _e5587 = f32(_e5586);
let _e5591 = ((_e5569 - (_e5587 * 0.6933594f)) - (_e5587 * -2.1219444e-4f));
let _e5614 = -((_e5255 * (_e4208 * _e4093.member)));
let _e5616 = select(-87f, _e5614, (_e5614 > -87f));
let _e5618 = select(88f, _e5616, (_e5616 < 88f));
let _e5620 = ((_e5618 * 1.442695f) + 0.5f);
let _e5622 = select(-127f, _e5620, (_e5620 > -127f));
let _e5624 = select(128f, _e5622, (_e5622 < 128f));
let _e5631 = select(0i, select(select(i32(_e5624), i32(-2147483648), (_e5624 < -2147483600f)), 2147483647i, (_e5624 > 2147483500f)), (_e5624 == _e5624));
let _e5635 = (_e5631 - select(0i, 1i, (_e5624 < f32(_e5631))));
let _e5636 = f32(_e5635);
let _e5640 = ((_e5618 - (_e5636 * 0.6933594f)) - (_e5636 * -2.1219444e-4f));
let _e5660 = ((1f + (_e5640 * (1f + (_e5640 * (0.5f + (_e5640 * (0.16666667f + (_e5640 * (0.041666668f + (_e5640 * (0.008333334f + (_e5640 * (0.001388889f + (_e5640 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5635 + 127i)) << bitcast<u32>(23i))));
let _e5661 = (1f - _e5660);
phi_12708_ = type_35(_e5660, _e5661, vec3<f32>(((1f + (_e5495 * (1f + (_e5495 * (0.5f + (_e5495 * (0.16666667f + (_e5495 * (0.041666668f + (_e5495 * (0.008333334f + (_e5495 * (0.001388889f + (_e5495 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5490 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5543 * (1f + (_e5543 * (0.5f + (_e5543 * (0.16666667f + (_e5543 * (0.041666668f + (_e5543 * (0.008333334f + (_e5543 * (0.001388889f + (_e5543 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5538 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5591 * (1f + (_e5591 * (0.5f + (_e5591 * (0.16666667f + (_e5591 * (0.041666668f + (_e5591 * (0.008333334f + (_e5591 * (0.001388889f + (_e5591 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5586 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e5661 / select(1e-12f, _e5255, (_e5255 > 1e-12f))))));
}
let _e5669 = phi_12708_;
if _e1229 {
let _e5674 = global_1.member.member_8.member.member;
let _e5682 = global_1.member.member_8.member_1.member;
let _e5690 = global_1.member.member_8.member_2.member;
let _e5694 = (-0.5f - _e1208);
let _e5695 = -(_e4101);
let _e5698 = (_e4101 - _e5694);
let _e5699 = (_e5694 - _e4101);
let _e5701 = select(_e5699, _e5698, (_e5698 > _e5699));
let _e5704 = (select(_e5695, _e4101, (_e4101 > _e5695)) / select(1e-30f, _e5701, (_e5701 > 1e-30f)));
let _e5706 = (_e5694 < 0f);
let _e5708 = select(0f, select(2f, _e5704, _e5706), (_e4101 > 0f));
let _e5709 = (_e5694 > 0f);
let _e5712 = select(2f, select(0f, _e5704, (_e4101 < 0f)), _e5709);
let _e5713 = (_e4101 > -1e30f);
let _e5717 = ((_e5708 > -1f) || ((_e5708 == -1f) && _e5713));
let _e5718 = (_e5712 < 2f);
let _e5719 = select(-1f, _e5708, _e5717);
let _e5723 = select(2f, _e5712, _e5718);
let _e5727 = select(-1e30f, _e4101, _e5713);
let _e5728 = (_e5694 > -1e30f);
let _e5729 = select(-1e30f, _e5694, _e5728);
let _e5733 = (_e1172 - _e3490);
let _e5734 = (_e1208 - _e3490);
let _e5735 = -(_e5733);
let _e5738 = (_e5733 - _e5734);
let _e5739 = (_e5734 - _e5733);
let _e5741 = select(_e5739, _e5738, (_e5738 > _e5739));
let _e5744 = (select(_e5735, _e5733, (_e5733 > _e5735)) / select(1e-30f, _e5741, (_e5741 > 1e-30f)));
let _e5746 = (_e5734 < 0f);
let _e5748 = select(0f, select(2f, _e5744, _e5746), (_e5733 > 0f));
let _e5749 = (_e5734 > 0f);
let _e5752 = select(2f, select(0f, _e5744, (_e5733 < 0f)), _e5749);
let _e5753 = (_e5733 > _e5727);
let _e5757 = ((_e5748 > _e5719) || ((_e5748 == _e5719) && _e5753));
let _e5758 = (_e5752 < _e5723);
let _e5759 = select(_e5719, _e5748, _e5757);
let _e5763 = select(_e5723, _e5752, _e5758);
let _e5767 = select(_e5727, _e5733, _e5753);
let _e5768 = (_e5734 > _e5729);
let _e5769 = select(_e5729, _e5734, _e5768);
let _e5773 = (-0.5f - _e1214);
let _e5774 = -(_e4130);
let _e5777 = (_e4130 - _e5773);
let _e5778 = (_e5773 - _e4130);
let _e5780 = select(_e5778, _e5777, (_e5777 > _e5778));
let _e5783 = (select(_e5774, _e4130, (_e4130 > _e5774)) / select(1e-30f, _e5780, (_e5780 > 1e-30f)));
let _e5785 = (_e5773 < 0f);
let _e5787 = select(0f, select(2f, _e5783, _e5785), (_e4130 > 0f));
let _e5788 = (_e5773 > 0f);
let _e5791 = select(2f, select(0f, _e5783, (_e4130 < 0f)), _e5788);
let _e5792 = (_e4130 > _e5767);
let _e5796 = ((_e5787 > _e5759) || ((_e5787 == _e5759) && _e5792));
let _e5797 = (_e5791 < _e5763);
let _e5798 = select(_e5759, _e5787, _e5796);
let _e5802 = select(_e5763, _e5791, _e5797);
let _e5806 = select(_e5767, _e4130, _e5792);
let _e5807 = (_e5773 > _e5769);
let _e5808 = select(_e5769, _e5773, _e5807);
let _e5812 = (_e1187 - _e3500);
let _e5813 = (_e1214 - _e3500);
let _e5814 = -(_e5812);
let _e5817 = (_e5812 - _e5813);
let _e5818 = (_e5813 - _e5812);
let _e5820 = select(_e5818, _e5817, (_e5817 > _e5818));
let _e5823 = (select(_e5814, _e5812, (_e5812 > _e5814)) / select(1e-30f, _e5820, (_e5820 > 1e-30f)));
let _e5825 = (_e5813 < 0f);
let _e5827 = select(0f, select(2f, _e5823, _e5825), (_e5812 > 0f));
let _e5828 = (_e5813 > 0f);
let _e5831 = select(2f, select(0f, _e5823, (_e5812 < 0f)), _e5828);
let _e5832 = (_e5812 > _e5806);
let _e5836 = ((_e5827 > _e5798) || ((_e5827 == _e5798) && _e5832));
let _e5837 = (_e5831 < _e5802);
let _e5838 = select(_e5798, _e5827, _e5836);
let _e5842 = select(_e5802, _e5831, _e5837);
let _e5846 = select(_e5806, _e5812, _e5832);
let _e5847 = (_e5813 > _e5808);
let _e5848 = select(_e5808, _e5813, _e5847);
let _e5852 = (-0.5f - _e1220);
let _e5853 = -(_e4159);
let _e5856 = (_e4159 - _e5852);
let _e5857 = (_e5852 - _e4159);
let _e5859 = select(_e5857, _e5856, (_e5856 > _e5857));
let _e5862 = (select(_e5853, _e4159, (_e4159 > _e5853)) / select(1e-30f, _e5859, (_e5859 > 1e-30f)));
let _e5864 = (_e5852 < 0f);
let _e5866 = select(0f, select(2f, _e5862, _e5864), (_e4159 > 0f));
let _e5867 = (_e5852 > 0f);
let _e5870 = select(2f, select(0f, _e5862, (_e4159 < 0f)), _e5867);
let _e5871 = (_e4159 > _e5846);
let _e5875 = ((_e5866 > _e5838) || ((_e5866 == _e5838) && _e5871));
let _e5876 = (_e5870 < _e5842);
let _e5877 = select(_e5838, _e5866, _e5875);
let _e5881 = select(_e5842, _e5870, _e5876);
let _e5885 = select(_e5846, _e4159, _e5871);
let _e5886 = (_e5852 > _e5848);
let _e5887 = select(_e5848, _e5852, _e5886);
let _e5891 = (_e1202 - _e3510);
let _e5892 = (_e1220 - _e3510);
let _e5893 = -(_e5891);
let _e5896 = (_e5891 - _e5892);
let _e5897 = (_e5892 - _e5891);
let _e5899 = select(_e5897, _e5896, (_e5896 > _e5897));
let _e5902 = (select(_e5893, _e5891, (_e5891 > _e5893)) / select(1e-30f, _e5899, (_e5899 > 1e-30f)));
let _e5904 = (_e5892 < 0f);
let _e5906 = select(0f, select(2f, _e5902, _e5904), (_e5891 > 0f));
let _e5907 = (_e5892 > 0f);
let _e5910 = select(2f, select(0f, _e5902, (_e5891 < 0f)), _e5907);
let _e5911 = (_e5891 > _e5885);
let _e5915 = ((_e5906 > _e5877) || ((_e5906 == _e5877) && _e5911));
let _e5916 = (_e5910 < _e5881);
let _e5917 = select(_e5877, _e5906, _e5915);
let _e5918 = select(select(select(select(select(select(0f, _e5674.member, _e5717), _e5674.member, _e5757), _e5682.member, _e5796), _e5682.member, _e5836), _e5690.member, _e5875), _e5690.member, _e5915);
let _e5919 = select(select(select(select(select(select(0f, _e5674.member_1, _e5717), _e5674.member_1, _e5757), _e5682.member_1, _e5796), _e5682.member_1, _e5836), _e5690.member_1, _e5875), _e5690.member_1, _e5915);
let _e5920 = select(select(select(select(select(select(1f, _e5674.member_2, _e5717), _e5674.member_2, _e5757), _e5682.member_2, _e5796), _e5682.member_2, _e5836), _e5690.member_2, _e5875), _e5690.member_2, _e5915);
let _e5922 = select(_e5881, _e5910, _e5916);
let _e5923 = select(select(select(select(select(select(0f, _e5674.member, _e5718), _e5674.member, _e5758), _e5682.member, _e5797), _e5682.member, _e5837), _e5690.member, _e5876), _e5690.member, _e5916);
let _e5924 = select(select(select(select(select(select(0f, _e5674.member_1, _e5718), _e5674.member_1, _e5758), _e5682.member_1, _e5797), _e5682.member_1, _e5837), _e5690.member_1, _e5876), _e5690.member_1, _e5916);
let _e5925 = select(select(select(select(select(select(1f, _e5674.member_2, _e5718), _e5674.member_2, _e5758), _e5682.member_2, _e5797), _e5682.member_2, _e5837), _e5690.member_2, _e5876), _e5690.member_2, _e5916);
let _e5927 = select(_e5885, _e5891, _e5911);
let _e5928 = (_e5892 > _e5887);
let _e5929 = select(_e5887, _e5892, _e5928);
let _e5930 = select(select(select(select(select(select(0f, _e5674.member, _e5713), _e5674.member, _e5753), _e5682.member, _e5792), _e5682.member, _e5832), _e5690.member, _e5871), _e5690.member, _e5911);
let _e5931 = select(select(select(select(select(select(0f, _e5674.member_1, _e5713), _e5674.member_1, _e5753), _e5682.member_1, _e5792), _e5682.member_1, _e5832), _e5690.member_1, _e5871), _e5690.member_1, _e5911);
let _e5932 = select(select(select(select(select(select(1f, _e5674.member_2, _e5713), _e5674.member_2, _e5753), _e5682.member_2, _e5792), _e5682.member_2, _e5832), _e5690.member_2, _e5871), _e5690.member_2, _e5911);
if _e3890 {
phi_14027_ = type_34(_e5917, vec3<f32>(_e5918, _e5919, _e5920), _e5922, vec3<f32>(_e5923, _e5924, _e5925), _e5927, _e5929, vec3<f32>(_e5930, _e5931, _e5932));
} else {
let _e5939 = (((_e5674.member * _e5674.member) + (_e5674.member_1 * _e5674.member_1)) + (_e5674.member_2 * _e5674.member_2));
let _e5942 = sqrt(select(0f, _e5939, (_e5939 > 0f)));
let _e5946 = global_1.member.member_16.member_1;
let _e5947 = (_e5946 != 0u);
let _e5951 = global_1.member.member_16.member;
let _e5971 = select(-1e6f, (((((_e5951.member.member * _e1129) + (_e5951.member.member_1 * _e1142)) + (_e5951.member.member_2 * _e1107)) + _e5951.member_1) * _e5942), _e5947);
let _e5972 = select(-1e6f, (((((_e5951.member.member * _e1152) + (_e5951.member.member_1 * _e1157)) + (_e5951.member.member_2 * _e1146)) + _e5951.member_1) * _e5942), _e5947);
let _e5977 = global_1.member.member_16.member.member;
let _e5981 = -(_e5971);
let _e5984 = (_e5971 - _e5972);
let _e5985 = (_e5972 - _e5971);
let _e5987 = select(_e5985, _e5984, (_e5984 > _e5985));
let _e5990 = (select(_e5981, _e5971, (_e5971 > _e5981)) / select(1e-30f, _e5987, (_e5987 > 1e-30f)));
let _e5994 = select(0f, select(2f, _e5990, (_e5972 < 0f)), (_e5971 > 0f));
let _e5998 = select(2f, select(0f, _e5990, (_e5971 < 0f)), (_e5972 > 0f));
let _e5999 = (_e5971 > _e5927);
let _e6003 = ((_e5994 > _e5917) || ((_e5994 == _e5917) && _e5999));
let _e6004 = (_e5998 < _e5922);
let _e6005 = select(_e5917, _e5994, _e6003);
let _e6009 = select(_e5922, _e5998, _e6004);
let _e6013 = select(_e5927, _e5971, _e5999);
let _e6015 = select(_e5929, _e5972, (_e5972 > _e5929));
let _e6022 = global_1.member.member_17.member_1;
let _e6023 = (_e6022 != 0u);
let _e6027 = global_1.member.member_17.member;
let _e6047 = select(-1e6f, (((((_e6027.member.member * _e1129) + (_e6027.member.member_1 * _e1142)) + (_e6027.member.member_2 * _e1107)) + _e6027.member_1) * _e5942), _e6023);
let _e6048 = select(-1e6f, (((((_e6027.member.member * _e1152) + (_e6027.member.member_1 * _e1157)) + (_e6027.member.member_2 * _e1146)) + _e6027.member_1) * _e5942), _e6023);
let _e6053 = global_1.member.member_17.member.member;
let _e6057 = -(_e6047);
let _e6060 = (_e6047 - _e6048);
let _e6061 = (_e6048 - _e6047);
let _e6063 = select(_e6061, _e6060, (_e6060 > _e6061));
let _e6066 = (select(_e6057, _e6047, (_e6047 > _e6057)) / select(1e-30f, _e6063, (_e6063 > 1e-30f)));
let _e6070 = select(0f, select(2f, _e6066, (_e6048 < 0f)), (_e6047 > 0f));
let _e6074 = select(2f, select(0f, _e6066, (_e6047 < 0f)), (_e6048 > 0f));
let _e6075 = (_e6047 > _e6013);
let _e6079 = ((_e6070 > _e6005) || ((_e6070 == _e6005) && _e6075));
let _e6080 = (_e6074 < _e6009);
let _e6081 = select(_e6005, _e6070, _e6079);
let _e6085 = select(_e6009, _e6074, _e6080);
let _e6089 = select(_e6013, _e6047, _e6075);
let _e6091 = select(_e6015, _e6048, (_e6048 > _e6015));
let _e6098 = global_1.member.member_18.member_1;
let _e6099 = (_e6098 != 0u);
let _e6103 = global_1.member.member_18.member;
let _e6123 = select(-1e6f, (((((_e6103.member.member * _e1129) + (_e6103.member.member_1 * _e1142)) + (_e6103.member.member_2 * _e1107)) + _e6103.member_1) * _e5942), _e6099);
let _e6124 = select(-1e6f, (((((_e6103.member.member * _e1152) + (_e6103.member.member_1 * _e1157)) + (_e6103.member.member_2 * _e1146)) + _e6103.member_1) * _e5942), _e6099);
let _e6129 = global_1.member.member_18.member.member;
let _e6133 = -(_e6123);
let _e6136 = (_e6123 - _e6124);
let _e6137 = (_e6124 - _e6123);
let _e6139 = select(_e6137, _e6136, (_e6136 > _e6137));
let _e6142 = (select(_e6133, _e6123, (_e6123 > _e6133)) / select(1e-30f, _e6139, (_e6139 > 1e-30f)));
let _e6146 = select(0f, select(2f, _e6142, (_e6124 < 0f)), (_e6123 > 0f));
let _e6150 = select(2f, select(0f, _e6142, (_e6123 < 0f)), (_e6124 > 0f));
let _e6151 = (_e6123 > _e6089);
let _e6155 = ((_e6146 > _e6081) || ((_e6146 == _e6081) && _e6151));
let _e6156 = (_e6150 < _e6085);
let _e6157 = select(_e6081, _e6146, _e6155);
let _e6161 = select(_e6085, _e6150, _e6156);
let _e6165 = select(_e6089, _e6123, _e6151);
let _e6167 = select(_e6091, _e6124, (_e6124 > _e6091));
let _e6174 = global_1.member.member_19.member_1;
let _e6175 = (_e6174 != 0u);
let _e6179 = global_1.member.member_19.member;
let _e6199 = select(-1e6f, (((((_e6179.member.member * _e1129) + (_e6179.member.member_1 * _e1142)) + (_e6179.member.member_2 * _e1107)) + _e6179.member_1) * _e5942), _e6175);
let _e6200 = select(-1e6f, (((((_e6179.member.member * _e1152) + (_e6179.member.member_1 * _e1157)) + (_e6179.member.member_2 * _e1146)) + _e6179.member_1) * _e5942), _e6175);
let _e6205 = global_1.member.member_19.member.member;
let _e6209 = -(_e6199);
let _e6212 = (_e6199 - _e6200);
let _e6213 = (_e6200 - _e6199);
let _e6215 = select(_e6213, _e6212, (_e6212 > _e6213));
let _e6218 = (select(_e6209, _e6199, (_e6199 > _e6209)) / select(1e-30f, _e6215, (_e6215 > 1e-30f)));
let _e6222 = select(0f, select(2f, _e6218, (_e6200 < 0f)), (_e6199 > 0f));
let _e6226 = select(2f, select(0f, _e6218, (_e6199 < 0f)), (_e6200 > 0f));
let _e6227 = (_e6199 > _e6165);
let _e6231 = ((_e6222 > _e6157) || ((_e6222 == _e6157) && _e6227));
let _e6232 = (_e6226 < _e6161);
phi_14027_ = type_34(select(_e6157, _e6222, _e6231), vec3<f32>(select(select(select(select(_e5918, _e5977.member, _e6003), _e6053.member, _e6079), _e6129.member, _e6155), _e6205.member, _e6231), select(select(select(select(_e5919, _e5977.member_1, _e6003), _e6053.member_1, _e6079), _e6129.member_1, _e6155), _e6205.member_1, _e6231), select(select(select(select(_e5920, _e5977.member_2, _e6003), _e6053.member_2, _e6079), _e6129.member_2, _e6155), _e6205.member_2, _e6231)), select(_e6161, _e6226, _e6232), vec3<f32>(select(select(select(select(_e5923, _e5977.member, _e6004), _e6053.member, _e6080), _e6129.member, _e6156), _e6205.member, _e6232), select(select(select(select(_e5924, _e5977.member_1, _e6004), _e6053.member_1, _e6080), _e6129.member_1, _e6156), _e6205.member_1, _e6232), select(select(select(select(_e5925, _e5977.member_2, _e6004), _e6053.member_2, _e6080), _e6129.member_2, _e6156), _e6205.member_2, _e6232)), select(_e6165, _e6199, _e6227), select(_e6167, _e6200, (_e6200 > _e6167)), vec3<f32>(select(select(select(select(_e5930, _e5977.member, _e5999), _e6053.member, _e6075), _e6129.member, _e6151), _e6205.member, _e6227), select(select(select(select(_e5931, _e5977.member_1, _e5999), _e6053.member_1, _e6075), _e6129.member_1, _e6151), _e6205.member_1, _e6227), select(select(select(select(_e5932, _e5977.member_2, _e5999), _e6053.member_2, _e6075), _e6129.member_2, _e6151), _e6205.member_2, _e6227)));
}
let _e6252 = phi_14027_;
let _e6254 = (_e6252.member_4 < 0f);
let _e6256 = (_e6252.member_5 < 0f);
let _e6257 = (_e6254 != _e6256);
if _e6254 {
phi_14040_ = _e6252.member_3;
phi_14041_ = _e6252.member_2;
} else {
phi_14040_ = _e6252.member_1;
phi_14041_ = _e6252.member;
}
let _e6263 = phi_14040_;
let _e6265 = phi_14041_;
let _e6274 = (((_e5674.member * _e5674.member) + (_e5674.member_1 * _e5674.member_1)) + (_e5674.member_2 * _e5674.member_2));
let _e6277 = sqrt(select(0f, _e6274, (_e6274 > 0f)));
let _e6278 = ((1.5f * _e1127) * _e6277);
let _e6283 = select(0f, _e6265, _e6257);
let _e6287 = (_e1129 + (_e4192 * _e6283));
let _e6288 = (_e1142 + (_e4193 * _e6283));
let _e6289 = (_e1107 + (_e4194 * _e6283));
let _e6295 = ((((_e1161.member.member * _e6287) + (_e1161.member.member_1 * _e6288)) + (_e1161.member.member_2 * _e6289)) + _e1161.member_1);
let _e6301 = ((((_e1176.member.member * _e6287) + (_e1176.member.member_1 * _e6288)) + (_e1176.member.member_2 * _e6289)) + _e1176.member_1);
let _e6307 = ((((_e1191.member.member * _e6287) + (_e1191.member.member_1 * _e6288)) + (_e1191.member.member_2 * _e6289)) + _e1191.member_1);
let _e6309 = select(-0.5f, _e6295, (_e6295 > -0.5f));
let _e6311 = select(_e3490, _e6309, (_e6309 < _e3490));
let _e6313 = select(-0.5f, _e6301, (_e6301 > -0.5f));
let _e6315 = select(_e3500, _e6313, (_e6313 < _e3500));
let _e6317 = select(-0.5f, _e6307, (_e6307 > -0.5f));
let _e6319 = select(_e3510, _e6317, (_e6317 < _e3510));
let _e6321 = select(-1f, _e6311, (_e6311 > -1f));
let _e6323 = select(_e3489, _e6321, (_e6321 < _e3489));
let _e6330 = select(0i, select(select(i32(_e6323), i32(-2147483648), (_e6323 < -2147483600f)), 2147483647i, (_e6323 > 2147483500f)), (_e6323 == _e6323));
let _e6334 = (_e6330 - select(0i, 1i, (_e6323 < f32(_e6330))));
let _e6336 = select(-1f, _e6315, (_e6315 > -1f));
let _e6338 = select(_e3499, _e6336, (_e6336 < _e3499));
let _e6345 = select(0i, select(select(i32(_e6338), i32(-2147483648), (_e6338 < -2147483600f)), 2147483647i, (_e6338 > 2147483500f)), (_e6338 == _e6338));
let _e6349 = (_e6345 - select(0i, 1i, (_e6338 < f32(_e6345))));
let _e6351 = select(-1f, _e6319, (_e6319 > -1f));
let _e6353 = select(_e3509, _e6351, (_e6351 < _e3509));
let _e6360 = select(0i, select(select(i32(_e6353), i32(-2147483648), (_e6353 < -2147483600f)), 2147483647i, (_e6353 > 2147483500f)), (_e6353 == _e6353));
let _e6364 = (_e6360 - select(0i, 1i, (_e6353 < f32(_e6360))));
let _e6367 = (_e6349 + 1i);
let _e6372 = (_e6364 + 1i);
let _e6375 = (_e6334 - 1i);
let _e6377 = select(0i, _e6375, (_e6375 > 0i));
let _e6380 = (_e6334 + 1i);
let _e6383 = (_e6334 + 2i);
let _e6387 = select(_e3615, _e6377, (_e6377 < _e3615));
let _e6400 = (select(0i, _e6349, (_e6349 > 0i)) * _e3563);
let _e6401 = (select(_e3575, _e6367, (_e6367 < _e3575)) * _e3563);
let _e6402 = (select(0i, _e6364, (_e6364 > 0i)) * _e3567);
let _e6403 = (select(_e3588, _e6372, (_e6372 < _e3588)) * _e3567);
local_2 = type_29(array<i32, 4>(_e6387, _e6387, _e6387, _e6387), array<u32, 6>(bitcast<u32>(((_e6377 - _e6387) * 8i)), bitcast<u32>(((select(0i, _e6334, (_e6334 > 0i)) - _e6387) * 8i)), bitcast<u32>(((select(_e3601, _e6380, (_e6380 < _e3601)) - _e6387) * 8i)), bitcast<u32>(((select(_e3601, _e6383, (_e6383 < _e3601)) - _e6387) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e6311 - f32(_e6334)), (_e6315 - f32(_e6349)), (_e6319 - f32(_e6364)));
let _e6418 = local_2.member[0u];
let _e6419 = ((_e6402 + _e6400) + _e6418);
let _e6421 = (_e6419 >> bitcast<u32>(2i));
let _e6424 = bitcast<u32>(((_e6419 & 3i) * 8i));
let _e6426 = select(_e3656, _e6421, (_e6421 < _e3656));
let _e6431 = global_2.member[bitcast<u32>(select(0i, _e6426, (_e6426 > 0i)))];
let _e6435 = (_e6421 + 1i);
let _e6437 = select(_e3656, _e6435, (_e6435 < _e3656));
let _e6442 = global_2.member[bitcast<u32>(select(0i, _e6437, (_e6437 > 0i)))];
let _e6449 = ((_e6431 >> bitcast<u32>((_e6424 & 31u))) | ((_e6442 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6424) & 31u))));
let _e6452 = local_2.member_1[1u];
let _e6458 = f32(bitcast<i32>(((_e6449 >> bitcast<u32>((_e6452 & 31u))) & 255u)));
let _e6461 = local_2.member_1[2u];
let _e6468 = local_3[0u];
let _e6471 = (_e6458 + ((f32(bitcast<i32>(((_e6449 >> bitcast<u32>((_e6461 & 31u))) & 255u))) - _e6458) * _e6468));
let _e6473 = local_2.member[0u];
let _e6474 = ((_e6402 + _e6401) + _e6473);
let _e6476 = (_e6474 >> bitcast<u32>(2i));
let _e6479 = bitcast<u32>(((_e6474 & 3i) * 8i));
let _e6481 = select(_e3656, _e6476, (_e6476 < _e3656));
let _e6486 = global_2.member[bitcast<u32>(select(0i, _e6481, (_e6481 > 0i)))];
let _e6490 = (_e6476 + 1i);
let _e6492 = select(_e3656, _e6490, (_e6490 < _e3656));
let _e6497 = global_2.member[bitcast<u32>(select(0i, _e6492, (_e6492 > 0i)))];
let _e6504 = ((_e6486 >> bitcast<u32>((_e6479 & 31u))) | ((_e6497 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6479) & 31u))));
let _e6505 = local_2.member_1[1u];
let _e6511 = f32(bitcast<i32>(((_e6504 >> bitcast<u32>((_e6505 & 31u))) & 255u)));
let _e6512 = local_2.member_1[2u];
let _e6519 = local_3[0u];
let _e6524 = local_3[1u];
let _e6527 = (_e6471 + (((_e6511 + ((f32(bitcast<i32>(((_e6504 >> bitcast<u32>((_e6512 & 31u))) & 255u))) - _e6511) * _e6519)) - _e6471) * _e6524));
let _e6529 = local_2.member[0u];
let _e6530 = ((_e6403 + _e6400) + _e6529);
let _e6532 = (_e6530 >> bitcast<u32>(2i));
let _e6535 = bitcast<u32>(((_e6530 & 3i) * 8i));
let _e6537 = select(_e3656, _e6532, (_e6532 < _e3656));
let _e6542 = global_2.member[bitcast<u32>(select(0i, _e6537, (_e6537 > 0i)))];
let _e6546 = (_e6532 + 1i);
let _e6548 = select(_e3656, _e6546, (_e6546 < _e3656));
let _e6553 = global_2.member[bitcast<u32>(select(0i, _e6548, (_e6548 > 0i)))];
let _e6560 = ((_e6542 >> bitcast<u32>((_e6535 & 31u))) | ((_e6553 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6535) & 31u))));
let _e6561 = local_2.member_1[1u];
let _e6567 = f32(bitcast<i32>(((_e6560 >> bitcast<u32>((_e6561 & 31u))) & 255u)));
let _e6568 = local_2.member_1[2u];
let _e6575 = local_3[0u];
let _e6578 = (_e6567 + ((f32(bitcast<i32>(((_e6560 >> bitcast<u32>((_e6568 & 31u))) & 255u))) - _e6567) * _e6575));
let _e6580 = local_2.member[0u];
let _e6581 = ((_e6403 + _e6401) + _e6580);
let _e6583 = (_e6581 >> bitcast<u32>(2i));
let _e6586 = bitcast<u32>(((_e6581 & 3i) * 8i));
let _e6588 = select(_e3656, _e6583, (_e6583 < _e3656));
let _e6593 = global_2.member[bitcast<u32>(select(0i, _e6588, (_e6588 > 0i)))];
let _e6597 = (_e6583 + 1i);
let _e6599 = select(_e3656, _e6597, (_e6597 < _e3656));
let _e6604 = global_2.member[bitcast<u32>(select(0i, _e6599, (_e6599 > 0i)))];
let _e6611 = ((_e6593 >> bitcast<u32>((_e6586 & 31u))) | ((_e6604 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6586) & 31u))));
let _e6612 = local_2.member_1[1u];
let _e6618 = f32(bitcast<i32>(((_e6611 >> bitcast<u32>((_e6612 & 31u))) & 255u)));
let _e6619 = local_2.member_1[2u];
let _e6626 = local_3[0u];
let _e6630 = local_3[1u];
let _e6635 = local_3[2u];
let _e6640 = (((_e6527 + (((_e6578 + (((_e6618 + ((f32(bitcast<i32>(((_e6611 >> bitcast<u32>((_e6619 & 31u))) & 255u))) - _e6618) * _e6626)) - _e6578) * _e6630)) - _e6527) * _e6635)) - _e3874) * _e3878);
let _e6642 = select(_e3881, _e6640, (_e6640 > _e3881));
local = select(1e9f, _e6642, (_e6642 < 1e9f));
let _e6645 = local;
local_1 = _e6645;
let _e6646 = local_1;
let _e6648 = (bitcast<i32>(_e165) - 1i);
let _e6650 = select(_e6648, 263197i, (263197i < _e6648));
let _e6655 = global_3.member[bitcast<u32>(select(0i, _e6650, (_e6650 > 0i)))];
let _e6658 = select(_e6648, 263198i, (263198i < _e6648));
let _e6663 = global_3.member[bitcast<u32>(select(0i, _e6658, (_e6658 > 0i)))];
let _e6666 = select(_e6648, 263199i, (263199i < _e6648));
let _e6671 = global_3.member[bitcast<u32>(select(0i, _e6666, (_e6666 > 0i)))];
let _e6672 = bitcast<f32>(_e6671);
let _e6674 = ((_e6646 - bitcast<f32>(_e6655)) * bitcast<f32>(_e6663));
let _e6676 = select(0f, _e6674, (_e6674 > 0f));
let _e6679 = local_1;
let _e6681 = select(_e6648, 263200i, (263200i < _e6648));
let _e6686 = global_3.member[bitcast<u32>(select(0i, _e6681, (_e6681 > 0i)))];
let _e6689 = select(_e6648, 263201i, (263201i < _e6648));
let _e6694 = global_3.member[bitcast<u32>(select(0i, _e6689, (_e6689 > 0i)))];
let _e6697 = select(_e6648, 263202i, (263202i < _e6648));
let _e6702 = global_3.member[bitcast<u32>(select(0i, _e6697, (_e6697 > 0i)))];
let _e6703 = bitcast<f32>(_e6702);
let _e6705 = ((_e6679 - bitcast<f32>(_e6686)) * bitcast<f32>(_e6694));
let _e6707 = select(0f, _e6705, (_e6705 > 0f));
let _e6711 = local_1;
let _e6713 = select(_e6648, 263203i, (263203i < _e6648));
let _e6718 = global_3.member[bitcast<u32>(select(0i, _e6713, (_e6713 > 0i)))];
let _e6721 = select(_e6648, 263204i, (263204i < _e6648));
let _e6726 = global_3.member[bitcast<u32>(select(0i, _e6721, (_e6721 > 0i)))];
let _e6729 = select(_e6648, 263205i, (263205i < _e6648));
let _e6734 = global_3.member[bitcast<u32>(select(0i, _e6729, (_e6729 > 0i)))];
let _e6735 = bitcast<f32>(_e6734);
let _e6737 = ((_e6711 - bitcast<f32>(_e6718)) * bitcast<f32>(_e6726));
let _e6739 = select(0f, _e6737, (_e6737 > 0f));
let _e6742 = local_1;
let _e6744 = select(_e6648, 263206i, (263206i < _e6648));
let _e6749 = global_3.member[bitcast<u32>(select(0i, _e6744, (_e6744 > 0i)))];
let _e6752 = select(_e6648, 263207i, (263207i < _e6648));
let _e6757 = global_3.member[bitcast<u32>(select(0i, _e6752, (_e6752 > 0i)))];
let _e6760 = select(_e6648, 263208i, (263208i < _e6648));
let _e6765 = global_3.member[bitcast<u32>(select(0i, _e6760, (_e6760 > 0i)))];
let _e6766 = bitcast<f32>(_e6765);
let _e6768 = ((_e6742 - bitcast<f32>(_e6749)) * bitcast<f32>(_e6757));
let _e6770 = select(0f, _e6768, (_e6768 > 0f));
let _e6774 = ((select(_e6672, _e6676, (_e6676 < _e6672)) + select(_e6703, _e6707, (_e6707 < _e6703))) + (select(_e6735, _e6739, (_e6739 < _e6735)) + select(_e6766, _e6770, (_e6770 < _e6766))));
let _e6776 = select(0f, _e6774, (_e6774 > 0f));
let _e6778 = select(1023f, _e6776, (_e6776 < 1023f));
let _e6785 = select(0i, select(select(i32(_e6778), i32(-2147483648), (_e6778 < -2147483600f)), 2147483647i, (_e6778 > 2147483500f)), (_e6778 == _e6778));
let _e6789 = (_e6785 - select(0i, 1i, (_e6778 < f32(_e6785))));
let _e6790 = (262147i + _e6789);
let _e6792 = select(_e6648, _e6790, (_e6790 < _e6648));
let _e6798 = global_3.member[bitcast<u32>(select(0i, _e6792, (_e6792 > 0i)))];
let _e6808 = select(_e6648, 262146i, (262146i < _e6648));
let _e6814 = global_3.member[bitcast<u32>(select(0i, _e6808, (_e6808 > 0i)))];
let _e6818 = select(_e6648, 262144i, (262144i < _e6648));
let _e6824 = global_3.member[bitcast<u32>(select(0i, _e6818, (_e6818 > 0i)))];
let _e6827 = select(_e6648, 262145i, (262145i < _e6648));
let _e6833 = global_3.member[bitcast<u32>(select(0i, _e6827, (_e6827 > 0i)))];
let _e6840 = ((bitcast<f32>(_e6824) + (f32(bitcast<i32>((_e6798 >> bitcast<u32>(12u)))) * bitcast<f32>(_e6833))) + ((f32((bitcast<i32>((_e6798 & 4095u)) - 2048i)) * bitcast<f32>(_e6814)) * (_e6774 - f32(_e6789))));
let _e6844 = select(_e6252.member_6.x, _e6263.x, _e6257);
let _e6847 = select(_e6252.member_6.y, _e6263.y, _e6257);
let _e6850 = select(_e6252.member_6.z, _e6263.z, _e6257);
let _e6851 = select(1f, _e6840, _e6256);
let _e6856 = (((_e6844 * _e6844) + (_e6847 * _e6847)) + (_e6850 * _e6850));
let _e6859 = sqrt(select(0f, _e6856, (_e6856 > 0f)));
let _e6862 = (1f / select(1e-20f, _e6859, (_e6859 > 1e-20f)));
let _e6863 = (_e6844 * _e6862);
let _e6864 = (_e6847 * _e6862);
let _e6865 = (_e6850 * _e6862);
let _e6870 = (((_e233 * _e6863) + (_e244 * _e6864)) + (_e255 * _e6865));
let _e6875 = (((_e233 * _e233) + (_e244 * _e244)) + (_e255 * _e255));
let _e6877 = ((_e6851 * _e6851) - _e6875);
let _e6878 = (_e6870 * _e6870);
let _e6879 = (_e6878 + _e6877);
let _e6882 = sqrt(select(0f, _e6879, (_e6879 > 0f)));
let _e6886 = (_e6879 <= 0f);
let _e6889 = select((select(_e6882, -(_e6882), (_e6870 < 0f)) - _e6870), (-2f * _e6870), _e6886);
let _e6890 = (_e6877 == 0f);
let _e6901 = (_e6886 && (_e6877 != 0f));
let _e6907 = (!(_e6257) && (_e6901 || (_e6878 < ((0.1f * 0.1f) * _e6875))));
let _e6909 = select(1e-12f, _e6875, (_e6875 > 1e-12f));
let _e6913 = (_e6851 / sqrt(select(0f, _e6909, (_e6909 > 0f))));
let _e6925 = ((_e6257 || (bitcast<f32>((bitcast<u32>(_e6252.member_4) & 2147483647u)) < select(1f, _e6278, (_e6278 < 1f)))) && (_e6840 != 1f));
let _e6926 = select(_e233, select(select(select((_e233 + (_e6863 * _e6889)), _e233, _e6890), _e233, _e6901), (_e233 * _e6913), _e6907), _e6925);
let _e6927 = select(_e244, select(select(select((_e244 + (_e6864 * _e6889)), _e244, _e6890), _e244, _e6901), (_e244 * _e6913), _e6907), _e6925);
let _e6928 = select(_e255, select(select(select((_e255 + (_e6865 * _e6889)), _e255, _e6890), _e255, _e6901), (_e255 * _e6913), _e6907), _e6925);
let _e6940 = global_1.member.member_7.member_2;
let _e6943 = (_e6940 / select(1e-6f, _e6928, (_e6928 > 1e-6f)));
let _e6947 = (_e1152 + (_e6926 * _e6943));
let _e6948 = (_e1157 + (_e6927 * _e6943));
let _e6949 = (_e1146 + (_e6928 * _e6943));
let _e6955 = ((((_e1161.member.member * _e6947) + (_e1161.member.member_1 * _e6948)) + (_e1161.member.member_2 * _e6949)) + _e1161.member_1);
let _e6961 = ((((_e1176.member.member * _e6947) + (_e1176.member.member_1 * _e6948)) + (_e1176.member.member_2 * _e6949)) + _e1176.member_1);
let _e6967 = ((((_e1191.member.member * _e6947) + (_e1191.member.member_1 * _e6948)) + (_e1191.member.member_2 * _e6949)) + _e1191.member_1);
let _e6968 = (-0.5f - _e6955);
let _e6969 = -(_e5694);
let _e6972 = (_e5694 - _e6968);
let _e6973 = (_e6968 - _e5694);
let _e6975 = select(_e6973, _e6972, (_e6972 > _e6973));
let _e6978 = (select(_e6969, _e5694, (_e5694 > _e6969)) / select(1e-30f, _e6975, (_e6975 > 1e-30f)));
let _e6981 = select(0f, select(2f, _e6978, (_e6968 < 0f)), _e5709);
let _e6984 = select(2f, select(0f, _e6978, _e5706), (_e6968 > 0f));
let _e6988 = ((_e6981 > -1f) || ((_e6981 == -1f) && _e5728));
let _e6989 = (_e6984 < 2f);
let _e6990 = select(-1f, _e6981, _e6988);
let _e6994 = select(2f, _e6984, _e6989);
let _e6999 = select(-1e30f, _e6968, (_e6968 > -1e30f));
let _e7003 = (_e6955 - _e3490);
let _e7004 = -(_e5734);
let _e7007 = (_e5734 - _e7003);
let _e7008 = (_e7003 - _e5734);
let _e7010 = select(_e7008, _e7007, (_e7007 > _e7008));
let _e7013 = (select(_e7004, _e5734, (_e5734 > _e7004)) / select(1e-30f, _e7010, (_e7010 > 1e-30f)));
let _e7016 = select(0f, select(2f, _e7013, (_e7003 < 0f)), _e5749);
let _e7019 = select(2f, select(0f, _e7013, _e5746), (_e7003 > 0f));
let _e7023 = ((_e7016 > _e6990) || ((_e7016 == _e6990) && _e5768));
let _e7024 = (_e7019 < _e6994);
let _e7025 = select(_e6990, _e7016, _e7023);
let _e7029 = select(_e6994, _e7019, _e7024);
let _e7034 = select(_e6999, _e7003, (_e7003 > _e6999));
let _e7038 = (-0.5f - _e6961);
let _e7039 = -(_e5773);
let _e7042 = (_e5773 - _e7038);
let _e7043 = (_e7038 - _e5773);
let _e7045 = select(_e7043, _e7042, (_e7042 > _e7043));
let _e7048 = (select(_e7039, _e5773, (_e5773 > _e7039)) / select(1e-30f, _e7045, (_e7045 > 1e-30f)));
let _e7051 = select(0f, select(2f, _e7048, (_e7038 < 0f)), _e5788);
let _e7054 = select(2f, select(0f, _e7048, _e5785), (_e7038 > 0f));
let _e7058 = ((_e7051 > _e7025) || ((_e7051 == _e7025) && _e5807));
let _e7059 = (_e7054 < _e7029);
let _e7060 = select(_e7025, _e7051, _e7058);
let _e7064 = select(_e7029, _e7054, _e7059);
let _e7069 = select(_e7034, _e7038, (_e7038 > _e7034));
let _e7073 = (_e6961 - _e3500);
let _e7074 = -(_e5813);
let _e7077 = (_e5813 - _e7073);
let _e7078 = (_e7073 - _e5813);
let _e7080 = select(_e7078, _e7077, (_e7077 > _e7078));
let _e7083 = (select(_e7074, _e5813, (_e5813 > _e7074)) / select(1e-30f, _e7080, (_e7080 > 1e-30f)));
let _e7086 = select(0f, select(2f, _e7083, (_e7073 < 0f)), _e5828);
let _e7089 = select(2f, select(0f, _e7083, _e5825), (_e7073 > 0f));
let _e7093 = ((_e7086 > _e7060) || ((_e7086 == _e7060) && _e5847));
let _e7094 = (_e7089 < _e7064);
let _e7095 = select(_e7060, _e7086, _e7093);
let _e7099 = select(_e7064, _e7089, _e7094);
let _e7104 = select(_e7069, _e7073, (_e7073 > _e7069));
let _e7108 = (-0.5f - _e6967);
let _e7109 = -(_e5852);
let _e7112 = (_e5852 - _e7108);
let _e7113 = (_e7108 - _e5852);
let _e7115 = select(_e7113, _e7112, (_e7112 > _e7113));
let _e7118 = (select(_e7109, _e5852, (_e5852 > _e7109)) / select(1e-30f, _e7115, (_e7115 > 1e-30f)));
let _e7121 = select(0f, select(2f, _e7118, (_e7108 < 0f)), _e5867);
let _e7124 = select(2f, select(0f, _e7118, _e5864), (_e7108 > 0f));
let _e7128 = ((_e7121 > _e7095) || ((_e7121 == _e7095) && _e5886));
let _e7129 = (_e7124 < _e7099);
let _e7130 = select(_e7095, _e7121, _e7128);
let _e7134 = select(_e7099, _e7124, _e7129);
let _e7139 = select(_e7104, _e7108, (_e7108 > _e7104));
let _e7143 = (_e6967 - _e3510);
let _e7144 = -(_e5892);
let _e7147 = (_e5892 - _e7143);
let _e7148 = (_e7143 - _e5892);
let _e7150 = select(_e7148, _e7147, (_e7147 > _e7148));
let _e7153 = (select(_e7144, _e5892, (_e5892 > _e7144)) / select(1e-30f, _e7150, (_e7150 > 1e-30f)));
let _e7156 = select(0f, select(2f, _e7153, (_e7143 < 0f)), _e5907);
let _e7159 = select(2f, select(0f, _e7153, _e5904), (_e7143 > 0f));
let _e7163 = ((_e7156 > _e7130) || ((_e7156 == _e7130) && _e5928));
let _e7164 = (_e7159 < _e7134);
let _e7165 = select(_e7130, _e7156, _e7163);
let _e7166 = select(select(select(select(select(select(0f, _e5674.member, _e6988), _e5674.member, _e7023), _e5682.member, _e7058), _e5682.member, _e7093), _e5690.member, _e7128), _e5690.member, _e7163);
let _e7167 = select(select(select(select(select(select(0f, _e5674.member_1, _e6988), _e5674.member_1, _e7023), _e5682.member_1, _e7058), _e5682.member_1, _e7093), _e5690.member_1, _e7128), _e5690.member_1, _e7163);
let _e7168 = select(select(select(select(select(select(1f, _e5674.member_2, _e6988), _e5674.member_2, _e7023), _e5682.member_2, _e7058), _e5682.member_2, _e7093), _e5690.member_2, _e7128), _e5690.member_2, _e7163);
let _e7170 = select(_e7134, _e7159, _e7164);
let _e7171 = select(select(select(select(select(select(0f, _e5674.member, _e6989), _e5674.member, _e7024), _e5682.member, _e7059), _e5682.member, _e7094), _e5690.member, _e7129), _e5690.member, _e7164);
let _e7172 = select(select(select(select(select(select(0f, _e5674.member_1, _e6989), _e5674.member_1, _e7024), _e5682.member_1, _e7059), _e5682.member_1, _e7094), _e5690.member_1, _e7129), _e5690.member_1, _e7164);
let _e7173 = select(select(select(select(select(select(1f, _e5674.member_2, _e6989), _e5674.member_2, _e7024), _e5682.member_2, _e7059), _e5682.member_2, _e7094), _e5690.member_2, _e7129), _e5690.member_2, _e7164);
let _e7176 = select(_e7139, _e7143, (_e7143 > _e7139));
let _e7177 = select(select(select(select(select(select(0f, _e5674.member, _e5728), _e5674.member, _e5768), _e5682.member, _e5807), _e5682.member, _e5847), _e5690.member, _e5886), _e5690.member, _e5928);
let _e7178 = select(select(select(select(select(select(0f, _e5674.member_1, _e5728), _e5674.member_1, _e5768), _e5682.member_1, _e5807), _e5682.member_1, _e5847), _e5690.member_1, _e5886), _e5690.member_1, _e5928);
let _e7179 = select(select(select(select(select(select(1f, _e5674.member_2, _e5728), _e5674.member_2, _e5768), _e5682.member_2, _e5807), _e5682.member_2, _e5847), _e5690.member_2, _e5886), _e5690.member_2, _e5928);
if _e3890 {
phi_16773_ = type_34(_e7165, vec3<f32>(_e7166, _e7167, _e7168), _e7170, vec3<f32>(_e7171, _e7172, _e7173), _e5929, _e7176, vec3<f32>(_e7177, _e7178, _e7179));
} else {
let _e7185 = global_1.member.member_16.member_1;
let _e7186 = (_e7185 != 0u);
let _e7190 = global_1.member.member_16.member;
let _e7210 = select(-1e6f, (((((_e7190.member.member * _e1152) + (_e7190.member.member_1 * _e1157)) + (_e7190.member.member_2 * _e1146)) + _e7190.member_1) * _e6277), _e7186);
let _e7211 = select(-1e6f, (((((_e7190.member.member * _e6947) + (_e7190.member.member_1 * _e6948)) + (_e7190.member.member_2 * _e6949)) + _e7190.member_1) * _e6277), _e7186);
let _e7216 = global_1.member.member_16.member.member;
let _e7220 = -(_e7210);
let _e7223 = (_e7210 - _e7211);
let _e7224 = (_e7211 - _e7210);
let _e7226 = select(_e7224, _e7223, (_e7223 > _e7224));
let _e7229 = (select(_e7220, _e7210, (_e7210 > _e7220)) / select(1e-30f, _e7226, (_e7226 > 1e-30f)));
let _e7233 = select(0f, select(2f, _e7229, (_e7211 < 0f)), (_e7210 > 0f));
let _e7237 = select(2f, select(0f, _e7229, (_e7210 < 0f)), (_e7211 > 0f));
let _e7238 = (_e7210 > _e5929);
let _e7242 = ((_e7233 > _e7165) || ((_e7233 == _e7165) && _e7238));
let _e7243 = (_e7237 < _e7170);
let _e7244 = select(_e7165, _e7233, _e7242);
let _e7248 = select(_e7170, _e7237, _e7243);
let _e7252 = select(_e5929, _e7210, _e7238);
let _e7254 = select(_e7176, _e7211, (_e7211 > _e7176));
let _e7261 = global_1.member.member_17.member_1;
let _e7262 = (_e7261 != 0u);
let _e7266 = global_1.member.member_17.member;
let _e7286 = select(-1e6f, (((((_e7266.member.member * _e1152) + (_e7266.member.member_1 * _e1157)) + (_e7266.member.member_2 * _e1146)) + _e7266.member_1) * _e6277), _e7262);
let _e7287 = select(-1e6f, (((((_e7266.member.member * _e6947) + (_e7266.member.member_1 * _e6948)) + (_e7266.member.member_2 * _e6949)) + _e7266.member_1) * _e6277), _e7262);
let _e7292 = global_1.member.member_17.member.member;
let _e7296 = -(_e7286);
let _e7299 = (_e7286 - _e7287);
let _e7300 = (_e7287 - _e7286);
let _e7302 = select(_e7300, _e7299, (_e7299 > _e7300));
let _e7305 = (select(_e7296, _e7286, (_e7286 > _e7296)) / select(1e-30f, _e7302, (_e7302 > 1e-30f)));
let _e7309 = select(0f, select(2f, _e7305, (_e7287 < 0f)), (_e7286 > 0f));
let _e7313 = select(2f, select(0f, _e7305, (_e7286 < 0f)), (_e7287 > 0f));
let _e7314 = (_e7286 > _e7252);
let _e7318 = ((_e7309 > _e7244) || ((_e7309 == _e7244) && _e7314));
let _e7319 = (_e7313 < _e7248);
let _e7320 = select(_e7244, _e7309, _e7318);
let _e7324 = select(_e7248, _e7313, _e7319);
let _e7328 = select(_e7252, _e7286, _e7314);
let _e7330 = select(_e7254, _e7287, (_e7287 > _e7254));
let _e7337 = global_1.member.member_18.member_1;
let _e7338 = (_e7337 != 0u);
let _e7342 = global_1.member.member_18.member;
let _e7362 = select(-1e6f, (((((_e7342.member.member * _e1152) + (_e7342.member.member_1 * _e1157)) + (_e7342.member.member_2 * _e1146)) + _e7342.member_1) * _e6277), _e7338);
let _e7363 = select(-1e6f, (((((_e7342.member.member * _e6947) + (_e7342.member.member_1 * _e6948)) + (_e7342.member.member_2 * _e6949)) + _e7342.member_1) * _e6277), _e7338);
let _e7368 = global_1.member.member_18.member.member;
let _e7372 = -(_e7362);
let _e7375 = (_e7362 - _e7363);
let _e7376 = (_e7363 - _e7362);
let _e7378 = select(_e7376, _e7375, (_e7375 > _e7376));
let _e7381 = (select(_e7372, _e7362, (_e7362 > _e7372)) / select(1e-30f, _e7378, (_e7378 > 1e-30f)));
let _e7385 = select(0f, select(2f, _e7381, (_e7363 < 0f)), (_e7362 > 0f));
let _e7389 = select(2f, select(0f, _e7381, (_e7362 < 0f)), (_e7363 > 0f));
let _e7390 = (_e7362 > _e7328);
let _e7394 = ((_e7385 > _e7320) || ((_e7385 == _e7320) && _e7390));
let _e7395 = (_e7389 < _e7324);
let _e7396 = select(_e7320, _e7385, _e7394);
let _e7400 = select(_e7324, _e7389, _e7395);
let _e7404 = select(_e7328, _e7362, _e7390);
let _e7406 = select(_e7330, _e7363, (_e7363 > _e7330));
let _e7413 = global_1.member.member_19.member_1;
let _e7414 = (_e7413 != 0u);
let _e7418 = global_1.member.member_19.member;
let _e7438 = select(-1e6f, (((((_e7418.member.member * _e1152) + (_e7418.member.member_1 * _e1157)) + (_e7418.member.member_2 * _e1146)) + _e7418.member_1) * _e6277), _e7414);
let _e7439 = select(-1e6f, (((((_e7418.member.member * _e6947) + (_e7418.member.member_1 * _e6948)) + (_e7418.member.member_2 * _e6949)) + _e7418.member_1) * _e6277), _e7414);
let _e7444 = global_1.member.member_19.member.member;
let _e7448 = -(_e7438);
let _e7451 = (_e7438 - _e7439);
let _e7452 = (_e7439 - _e7438);
let _e7454 = select(_e7452, _e7451, (_e7451 > _e7452));
let _e7457 = (select(_e7448, _e7438, (_e7438 > _e7448)) / select(1e-30f, _e7454, (_e7454 > 1e-30f)));
let _e7461 = select(0f, select(2f, _e7457, (_e7439 < 0f)), (_e7438 > 0f));
let _e7465 = select(2f, select(0f, _e7457, (_e7438 < 0f)), (_e7439 > 0f));
let _e7466 = (_e7438 > _e7404);
let _e7470 = ((_e7461 > _e7396) || ((_e7461 == _e7396) && _e7466));
let _e7471 = (_e7465 < _e7400);
phi_16773_ = type_34(select(_e7396, _e7461, _e7470), vec3<f32>(select(select(select(select(_e7166, _e7216.member, _e7242), _e7292.member, _e7318), _e7368.member, _e7394), _e7444.member, _e7470), select(select(select(select(_e7167, _e7216.member_1, _e7242), _e7292.member_1, _e7318), _e7368.member_1, _e7394), _e7444.member_1, _e7470), select(select(select(select(_e7168, _e7216.member_2, _e7242), _e7292.member_2, _e7318), _e7368.member_2, _e7394), _e7444.member_2, _e7470)), select(_e7400, _e7465, _e7471), vec3<f32>(select(select(select(select(_e7171, _e7216.member, _e7243), _e7292.member, _e7319), _e7368.member, _e7395), _e7444.member, _e7471), select(select(select(select(_e7172, _e7216.member_1, _e7243), _e7292.member_1, _e7319), _e7368.member_1, _e7395), _e7444.member_1, _e7471), select(select(select(select(_e7173, _e7216.member_2, _e7243), _e7292.member_2, _e7319), _e7368.member_2, _e7395), _e7444.member_2, _e7471)), select(_e7404, _e7438, _e7466), select(_e7406, _e7439, (_e7439 > _e7406)), vec3<f32>(select(select(select(select(_e7177, _e7216.member, _e7238), _e7292.member, _e7314), _e7368.member, _e7390), _e7444.member, _e7466), select(select(select(select(_e7178, _e7216.member_1, _e7238), _e7292.member_1, _e7314), _e7368.member_1, _e7390), _e7444.member_1, _e7466), select(select(select(select(_e7179, _e7216.member_2, _e7238), _e7292.member_2, _e7314), _e7368.member_2, _e7390), _e7444.member_2, _e7466)));
}
let _e7491 = phi_16773_;
let _e7500 = global_1.member.member_7.member_4;
let _e7503 = (_e3484.member_3.x * _e4093.member_2);
let _e7505 = (_e3484.member_3.y * _e4093.member_2);
let _e7507 = (_e3484.member_3.z * _e4093.member_2);
let _e7508 = (0.5f * (_e6943 * select(1f, (2f * (1f - _e6265)), (_e6257 && _e6256))));
let _e7512 = (_e6926 + (_e7503 * _e7508));
let _e7513 = (_e6927 + (_e7505 * _e7508));
let _e7514 = (_e6928 + (_e7507 * _e7508));
let _e7516 = (2f * _e6940);
let _e7518 = ((_e7514 * _e7514) + (_e7516 * _e7507));
let _e7522 = (_e7514 + sqrt(select(0f, _e7518, (_e7518 > 0f))));
let _e7526 = (select(0.5f, _e7491.member_2, (_e7491.member_2 < 1f)) * (_e7516 / select(1e-6f, _e7522, (_e7522 > 1e-6f))));
let _e7530 = (_e7512 + (_e7503 * _e7526));
let _e7531 = (_e7513 + (_e7505 * _e7526));
let _e7532 = (_e7514 + (_e7507 * _e7526));
let _e7536 = (_e7500 * _e7500);
let _e7538 = (_e7532 * _e7532);
let _e7546 = (((_e7514 <= 0f) || (_e7518 <= 0f)) || ((_e7532 <= 0f) || (_e7538 <= (_e7536 * (((_e7530 * _e7530) + (_e7531 * _e7531)) + _e7538)))));
let _e7560 = (_e6926 + ((_e3484.member_4.x * _e4093.member_2) * _e6940));
let _e7561 = (_e6927 + ((_e3484.member_4.y * _e4093.member_2) * _e6940));
let _e7562 = (_e6928 + ((_e3484.member_4.z * _e4093.member_2) * _e6940));
let _e7564 = (_e7562 * _e7562);
let _e7573 = ((_e3888 & 1u) != 0u);
let _e7578 = (select(_e7546, ((_e7562 <= 0f) || (_e7564 <= (_e7536 * (((_e7560 * _e7560) + (_e7561 * _e7561)) + _e7564)))), _e7573) || (_e6925 && ((_e6901 && _e6257) || (_e6257 && (_e6928 <= 0f)))));
phi_16925_ = vec3<f32>(select(select(select(_e7530, _e7512, _e7546), _e7560, _e7573), _e233, _e7578), select(select(select(_e7531, _e7513, _e7546), _e7561, _e7573), _e244, _e7578), select(select(select(_e7532, _e7514, _e7546), _e7562, _e7573), _e255, _e7578));
phi_16926_ = select(1f, 0f, _e7578);
} else {
phi_16925_ = vec3<f32>(_e233, _e244, _e255);
phi_16926_ = 1f;
}
let _e7585 = phi_16925_;
let _e7587 = phi_16926_;
let _e7590 = (_e5669.member * _e7587);
global_4.member[_e190] = (_e201 * (_e5669.member_2.x * _e7590));
global_4.member[_e202] = (_e211 * (_e5669.member_2.y * _e7590));
global_4.member[_e213] = (_e222 * (_e5669.member_2.z * _e7590));
global_4.member[_e224] = _e7585.x;
global_4.member[_e235] = _e7585.y;
global_4.member[_e246] = _e7585.z;
global_4.member[_e257] = _e266;
global_4.member[_e268] = _e277;
global_4.member[_e279] = _e288;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
