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
var phi_901_: bool;
var phi_1081_: bool;
var phi_1084_: bool;
var phi_1268_: bool;
var phi_1591_: u32;
var phi_6993_: type_32;
var phi_7603_: type_33;
var phi_8400_: type_7;
var phi_12128_: type_35;
var phi_13447_: type_34;
var phi_13460_: vec3<f32>;
var phi_13461_: f32;
var phi_16040_: type_34;
var phi_16192_: vec3<f32>;
var phi_16193_: f32;
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
phi_901_ = _e540;
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
phi_901_ = (_e540 && (((((((((_e550.member.member * _e346) + (_e550.member.member_1 * _e359)) + (_e550.member.member_2 * _e324)) + _e550.member_1) <= _e562) || (_e567 == 0u)) && ((((((_e573.member.member * _e346) + (_e573.member.member_1 * _e359)) + (_e573.member.member_2 * _e324)) + _e573.member_1) <= _e562) || (_e589 == 0u))) && ((((((_e596.member.member * _e346) + (_e596.member.member_1 * _e359)) + (_e596.member.member_2 * _e324)) + _e596.member_1) <= _e562) || (_e612 == 0u))) && ((((((_e619.member.member * _e346) + (_e619.member.member_1 * _e359)) + (_e619.member.member_2 * _e324)) + _e619.member_1) <= _e562) || (_e635 == 0u))));
}
let _e641 = phi_901_;
let _e645 = (_e369 + (_e369 - _e346));
let _e646 = (_e374 + (_e374 - _e359));
let _e647 = (_e363 + (_e363 - _e324));
let _e653 = ((((_e415.member.member * _e645) + (_e415.member.member_1 * _e646)) + (_e415.member.member_2 * _e647)) + _e415.member_1);
let _e659 = ((((_e430.member.member * _e645) + (_e430.member.member_1 * _e646)) + (_e430.member.member_2 * _e647)) + _e430.member_1);
let _e665 = ((((_e445.member.member * _e645) + (_e445.member.member_1 * _e646)) + (_e445.member.member_2 * _e647)) + _e445.member_1);
let _e676 = ((((_e653 >= _e525) && (_e653 <= _e528)) && ((_e659 >= _e525) && (_e659 <= _e532))) && ((_e665 >= _e525) && (_e665 <= _e537)));
if _e545 {
phi_1081_ = _e676;
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
phi_1081_ = (_e676 && (((((((((_e681.member.member * _e645) + (_e681.member.member_1 * _e646)) + (_e681.member.member_2 * _e647)) + _e681.member_1) <= _e693) || (_e698 == 0u)) && ((((((_e704.member.member * _e645) + (_e704.member.member_1 * _e646)) + (_e704.member.member_2 * _e647)) + _e704.member_1) <= _e693) || (_e720 == 0u))) && ((((((_e727.member.member * _e645) + (_e727.member.member_1 * _e646)) + (_e727.member.member_2 * _e647)) + _e727.member_1) <= _e693) || (_e743 == 0u))) && ((((((_e750.member.member * _e645) + (_e750.member.member_1 * _e646)) + (_e750.member.member_2 * _e647)) + _e750.member_1) <= _e693) || (_e766 == 0u))));
}
let _e772 = phi_1081_;
phi_1084_ = (_e515 && (_e641 && _e772));
} else {
phi_1084_ = _e515;
}
let _e776 = phi_1084_;
let _e783 = ((((_e415.member.member * _e409) + (_e415.member.member_1 * _e410)) + (_e415.member.member_2 * _e411)) + _e415.member_1);
let _e789 = ((((_e430.member.member * _e409) + (_e430.member.member_1 * _e410)) + (_e430.member.member_2 * _e411)) + _e430.member_1);
let _e795 = ((((_e445.member.member * _e409) + (_e445.member.member_1 * _e410)) + (_e445.member.member_2 * _e411)) + _e445.member_1);
let _e796 = (_e398 - 0.5f);
let _e797 = (_e398 + 0.5f);
let _e811 = ((((_e783 >= _e796) && (_e783 <= (_e480 - _e797))) && ((_e789 >= _e796) && (_e789 <= (_e490 - _e797)))) && ((_e795 >= _e796) && (_e795 <= (_e500 - _e797))));
let _e814 = global_1.member.member_1;
if ((_e814 & 16u) == 0u) {
phi_1268_ = _e811;
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
phi_1268_ = (_e811 && (((((((((_e821.member.member * _e409) + (_e821.member.member_1 * _e410)) + (_e821.member.member_2 * _e411)) + _e821.member_1) <= _e833) || (_e838 == 0u)) && ((((((_e844.member.member * _e409) + (_e844.member.member_1 * _e410)) + (_e844.member.member_2 * _e411)) + _e844.member_1) <= _e833) || (_e860 == 0u))) && ((((((_e867.member.member * _e409) + (_e867.member.member_1 * _e410)) + (_e867.member.member_2 * _e411)) + _e867.member_1) <= _e833) || (_e883 == 0u))) && ((((((_e890.member.member * _e409) + (_e890.member.member_1 * _e410)) + (_e890.member.member_2 * _e411)) + _e890.member_1) <= _e833) || (_e906 == 0u))));
}
let _e912 = phi_1268_;
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
phi_1591_ = select(select(7u, 3u, (_e776 && (!(_e524) || _e912))), 1u, (((_e814 & 64u) != 0u) || ((((select(_e948, _e945, (_e945 > _e948)) <= _e919) && ((select(_e965, _e962, (_e962 > _e965)) > _e919) || (_e1059 != 0u))) && true) && ((_e814 & 32u) != 0u))));
} else {
phi_1591_ = 7u;
}
let _e1072 = phi_1591_;
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
let _e1313 = (_e1274 + 1i);
let _e1314 = (_e1289 + 1i);
let _e1315 = (_e1304 + 1i);
let _e1320 = global_1.member.member_8.member_11.member;
let _e1326 = global_1.member.member_8.member_11.member_1;
let _e1337 = ((_e1313 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1320) * ((_e1314 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1326) * (_e1315 >> bitcast<u32>(4i))))));
let _e1339 = (bitcast<i32>(_e160) - 1i);
let _e1341 = select(_e1339, _e1337, (_e1337 < _e1339));
let _e1347 = global_2.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1349 = (_e1313 & 15i);
let _e1352 = ((_e1314 & 15i) * _e1308);
let _e1354 = (bitcast<i32>(_e1347) + ((_e1315 & 15i) * _e1312));
let _e1358 = (_e1352 + _e1308);
let _e1360 = (_e1352 + (2i * _e1308));
let _e1362 = (_e1352 + (3i * _e1308));
let _e1363 = (_e1354 + _e1312);
let _e1365 = (_e1354 + (2i * _e1312));
let _e1367 = (_e1354 + (3i * _e1312));
local_26 = type_29(array<i32, 4>(_e1349, (_e1349 + 1i), (_e1349 + 2i), (_e1349 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_27 = vec3<f32>((_e1239 - f32(_e1274)), (_e1249 - f32(_e1289)), (_e1259 - f32(_e1304)));
let _e1378 = (_e1363 + _e1358);
let _e1381 = local_26.member[0u];
let _e1382 = (_e1378 + _e1381);
let _e1384 = select(_e1339, _e1382, (_e1382 < _e1339));
let _e1389 = global_2.member[bitcast<u32>(select(0i, _e1384, (_e1384 > 0i)))];
let _e1390 = bitcast<f32>(_e1389);
let _e1393 = local_26.member[1u];
let _e1394 = (_e1378 + _e1393);
let _e1396 = select(_e1339, _e1394, (_e1394 < _e1339));
let _e1401 = global_2.member[bitcast<u32>(select(0i, _e1396, (_e1396 > 0i)))];
let _e1402 = bitcast<f32>(_e1401);
let _e1405 = local_26.member[2u];
let _e1406 = (_e1378 + _e1405);
let _e1408 = select(_e1339, _e1406, (_e1406 < _e1339));
let _e1413 = global_2.member[bitcast<u32>(select(0i, _e1408, (_e1408 > 0i)))];
let _e1414 = bitcast<f32>(_e1413);
let _e1417 = local_26.member[3u];
let _e1418 = (_e1378 + _e1417);
let _e1420 = select(_e1339, _e1418, (_e1418 < _e1339));
let _e1425 = global_2.member[bitcast<u32>(select(0i, _e1420, (_e1420 > 0i)))];
let _e1427 = local_27[0u];
let _e1430 = (_e1390 + ((_e1402 - _e1390) * _e1427));
let _e1431 = local_27[0u];
let _e1434 = (_e1402 + ((_e1414 - _e1402) * _e1431));
let _e1435 = local_27[0u];
let _e1438 = (_e1414 + ((bitcast<f32>(_e1425) - _e1414) * _e1435));
let _e1439 = (_e1363 + _e1360);
let _e1440 = local_26.member[0u];
let _e1441 = (_e1439 + _e1440);
let _e1443 = select(_e1339, _e1441, (_e1441 < _e1339));
let _e1448 = global_2.member[bitcast<u32>(select(0i, _e1443, (_e1443 > 0i)))];
let _e1449 = bitcast<f32>(_e1448);
let _e1450 = local_26.member[1u];
let _e1451 = (_e1439 + _e1450);
let _e1453 = select(_e1339, _e1451, (_e1451 < _e1339));
let _e1458 = global_2.member[bitcast<u32>(select(0i, _e1453, (_e1453 > 0i)))];
let _e1459 = bitcast<f32>(_e1458);
let _e1460 = local_26.member[2u];
let _e1461 = (_e1439 + _e1460);
let _e1463 = select(_e1339, _e1461, (_e1461 < _e1339));
let _e1468 = global_2.member[bitcast<u32>(select(0i, _e1463, (_e1463 > 0i)))];
let _e1469 = bitcast<f32>(_e1468);
let _e1470 = local_26.member[3u];
let _e1471 = (_e1439 + _e1470);
let _e1473 = select(_e1339, _e1471, (_e1471 < _e1339));
let _e1478 = global_2.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1480 = local_27[0u];
let _e1484 = local_27[0u];
let _e1487 = (_e1459 + ((_e1469 - _e1459) * _e1484));
let _e1488 = local_27[0u];
let _e1492 = (_e1365 + _e1358);
let _e1493 = local_26.member[0u];
let _e1494 = (_e1492 + _e1493);
let _e1496 = select(_e1339, _e1494, (_e1494 < _e1339));
let _e1501 = global_2.member[bitcast<u32>(select(0i, _e1496, (_e1496 > 0i)))];
let _e1502 = bitcast<f32>(_e1501);
let _e1503 = local_26.member[1u];
let _e1504 = (_e1492 + _e1503);
let _e1506 = select(_e1339, _e1504, (_e1504 < _e1339));
let _e1511 = global_2.member[bitcast<u32>(select(0i, _e1506, (_e1506 > 0i)))];
let _e1512 = bitcast<f32>(_e1511);
let _e1513 = local_26.member[2u];
let _e1514 = (_e1492 + _e1513);
let _e1516 = select(_e1339, _e1514, (_e1514 < _e1339));
let _e1521 = global_2.member[bitcast<u32>(select(0i, _e1516, (_e1516 > 0i)))];
let _e1522 = bitcast<f32>(_e1521);
let _e1523 = local_26.member[3u];
let _e1524 = (_e1492 + _e1523);
let _e1526 = select(_e1339, _e1524, (_e1524 < _e1339));
let _e1531 = global_2.member[bitcast<u32>(select(0i, _e1526, (_e1526 > 0i)))];
let _e1533 = local_27[0u];
let _e1536 = (_e1502 + ((_e1512 - _e1502) * _e1533));
let _e1537 = local_27[0u];
let _e1540 = (_e1512 + ((_e1522 - _e1512) * _e1537));
let _e1541 = local_27[0u];
let _e1544 = (_e1522 + ((bitcast<f32>(_e1531) - _e1522) * _e1541));
let _e1545 = (_e1365 + _e1360);
let _e1546 = local_26.member[0u];
let _e1547 = (_e1545 + _e1546);
let _e1549 = select(_e1339, _e1547, (_e1547 < _e1339));
let _e1554 = global_2.member[bitcast<u32>(select(0i, _e1549, (_e1549 > 0i)))];
let _e1555 = bitcast<f32>(_e1554);
let _e1556 = local_26.member[1u];
let _e1557 = (_e1545 + _e1556);
let _e1559 = select(_e1339, _e1557, (_e1557 < _e1339));
let _e1564 = global_2.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1565 = bitcast<f32>(_e1564);
let _e1566 = local_26.member[2u];
let _e1567 = (_e1545 + _e1566);
let _e1569 = select(_e1339, _e1567, (_e1567 < _e1339));
let _e1574 = global_2.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1575 = bitcast<f32>(_e1574);
let _e1576 = local_26.member[3u];
let _e1577 = (_e1545 + _e1576);
let _e1579 = select(_e1339, _e1577, (_e1577 < _e1339));
let _e1584 = global_2.member[bitcast<u32>(select(0i, _e1579, (_e1579 > 0i)))];
let _e1586 = local_27[0u];
let _e1590 = local_27[0u];
let _e1593 = (_e1565 + ((_e1575 - _e1565) * _e1590));
let _e1594 = local_27[0u];
let _e1598 = (_e1363 + _e1352);
let _e1599 = local_26.member[1u];
let _e1600 = (_e1598 + _e1599);
let _e1602 = select(_e1339, _e1600, (_e1600 < _e1339));
let _e1607 = global_2.member[bitcast<u32>(select(0i, _e1602, (_e1602 > 0i)))];
let _e1608 = bitcast<f32>(_e1607);
let _e1609 = local_26.member[2u];
let _e1610 = (_e1598 + _e1609);
let _e1612 = select(_e1339, _e1610, (_e1610 < _e1339));
let _e1617 = global_2.member[bitcast<u32>(select(0i, _e1612, (_e1612 > 0i)))];
let _e1619 = local_27[0u];
let _e1622 = (_e1608 + ((bitcast<f32>(_e1617) - _e1608) * _e1619));
let _e1623 = (_e1363 + _e1362);
let _e1624 = local_26.member[1u];
let _e1625 = (_e1623 + _e1624);
let _e1627 = select(_e1339, _e1625, (_e1625 < _e1339));
let _e1632 = global_2.member[bitcast<u32>(select(0i, _e1627, (_e1627 > 0i)))];
let _e1633 = bitcast<f32>(_e1632);
let _e1634 = local_26.member[2u];
let _e1635 = (_e1623 + _e1634);
let _e1637 = select(_e1339, _e1635, (_e1635 < _e1339));
let _e1642 = global_2.member[bitcast<u32>(select(0i, _e1637, (_e1637 > 0i)))];
let _e1644 = local_27[0u];
let _e1648 = (_e1365 + _e1352);
let _e1649 = local_26.member[1u];
let _e1650 = (_e1648 + _e1649);
let _e1652 = select(_e1339, _e1650, (_e1650 < _e1339));
let _e1657 = global_2.member[bitcast<u32>(select(0i, _e1652, (_e1652 > 0i)))];
let _e1658 = bitcast<f32>(_e1657);
let _e1659 = local_26.member[2u];
let _e1660 = (_e1648 + _e1659);
let _e1662 = select(_e1339, _e1660, (_e1660 < _e1339));
let _e1667 = global_2.member[bitcast<u32>(select(0i, _e1662, (_e1662 > 0i)))];
let _e1669 = local_27[0u];
let _e1672 = (_e1658 + ((bitcast<f32>(_e1667) - _e1658) * _e1669));
let _e1673 = (_e1365 + _e1362);
let _e1674 = local_26.member[1u];
let _e1675 = (_e1673 + _e1674);
let _e1677 = select(_e1339, _e1675, (_e1675 < _e1339));
let _e1682 = global_2.member[bitcast<u32>(select(0i, _e1677, (_e1677 > 0i)))];
let _e1683 = bitcast<f32>(_e1682);
let _e1684 = local_26.member[2u];
let _e1685 = (_e1673 + _e1684);
let _e1687 = select(_e1339, _e1685, (_e1685 < _e1339));
let _e1692 = global_2.member[bitcast<u32>(select(0i, _e1687, (_e1687 > 0i)))];
let _e1694 = local_27[0u];
let _e1698 = (_e1354 + _e1358);
let _e1699 = local_26.member[1u];
let _e1700 = (_e1698 + _e1699);
let _e1702 = select(_e1339, _e1700, (_e1700 < _e1339));
let _e1707 = global_2.member[bitcast<u32>(select(0i, _e1702, (_e1702 > 0i)))];
let _e1708 = bitcast<f32>(_e1707);
let _e1709 = local_26.member[2u];
let _e1710 = (_e1698 + _e1709);
let _e1712 = select(_e1339, _e1710, (_e1710 < _e1339));
let _e1717 = global_2.member[bitcast<u32>(select(0i, _e1712, (_e1712 > 0i)))];
let _e1719 = local_27[0u];
let _e1722 = (_e1708 + ((bitcast<f32>(_e1717) - _e1708) * _e1719));
let _e1723 = (_e1367 + _e1358);
let _e1724 = local_26.member[1u];
let _e1725 = (_e1723 + _e1724);
let _e1727 = select(_e1339, _e1725, (_e1725 < _e1339));
let _e1732 = global_2.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1733 = bitcast<f32>(_e1732);
let _e1734 = local_26.member[2u];
let _e1735 = (_e1723 + _e1734);
let _e1737 = select(_e1339, _e1735, (_e1735 < _e1339));
let _e1742 = global_2.member[bitcast<u32>(select(0i, _e1737, (_e1737 > 0i)))];
let _e1744 = local_27[0u];
let _e1747 = (_e1733 + ((bitcast<f32>(_e1742) - _e1733) * _e1744));
let _e1748 = (_e1354 + _e1360);
let _e1749 = local_26.member[1u];
let _e1750 = (_e1748 + _e1749);
let _e1752 = select(_e1339, _e1750, (_e1750 < _e1339));
let _e1757 = global_2.member[bitcast<u32>(select(0i, _e1752, (_e1752 > 0i)))];
let _e1758 = bitcast<f32>(_e1757);
let _e1759 = local_26.member[2u];
let _e1760 = (_e1748 + _e1759);
let _e1762 = select(_e1339, _e1760, (_e1760 < _e1339));
let _e1767 = global_2.member[bitcast<u32>(select(0i, _e1762, (_e1762 > 0i)))];
let _e1769 = local_27[0u];
let _e1773 = (_e1367 + _e1360);
let _e1774 = local_26.member[1u];
let _e1775 = (_e1773 + _e1774);
let _e1777 = select(_e1339, _e1775, (_e1775 < _e1339));
let _e1782 = global_2.member[bitcast<u32>(select(0i, _e1777, (_e1777 > 0i)))];
let _e1783 = bitcast<f32>(_e1782);
let _e1784 = local_26.member[2u];
let _e1785 = (_e1773 + _e1784);
let _e1787 = select(_e1339, _e1785, (_e1785 < _e1339));
let _e1792 = global_2.member[bitcast<u32>(select(0i, _e1787, (_e1787 > 0i)))];
let _e1794 = local_27[0u];
let _e1799 = local_27[1u];
let _e1802 = (_e1434 + ((_e1487 - _e1434) * _e1799));
let _e1803 = local_27[1u];
let _e1806 = (_e1540 + ((_e1593 - _e1540) * _e1803));
let _e1807 = local_27[1u];
let _e1810 = (_e1430 + (((_e1449 + ((_e1459 - _e1449) * _e1480)) - _e1430) * _e1807));
let _e1811 = local_27[1u];
let _e1816 = local_27[2u];
let _e1820 = local_27[1u];
let _e1823 = (_e1438 + (((_e1469 + ((bitcast<f32>(_e1478) - _e1469) * _e1488)) - _e1438) * _e1820));
let _e1824 = local_27[1u];
let _e1828 = local_27[2u];
let _e1832 = local_27[1u];
let _e1835 = (_e1622 + ((_e1434 - _e1622) * _e1832));
let _e1836 = local_27[1u];
let _e1840 = local_27[2u];
let _e1844 = local_27[1u];
let _e1847 = (_e1487 + (((_e1633 + ((bitcast<f32>(_e1642) - _e1633) * _e1644)) - _e1487) * _e1844));
let _e1848 = local_27[1u];
let _e1852 = local_27[2u];
let _e1856 = local_27[1u];
let _e1859 = (_e1722 + (((_e1758 + ((bitcast<f32>(_e1767) - _e1758) * _e1769)) - _e1722) * _e1856));
let _e1860 = local_27[2u];
let _e1864 = local_27[1u];
let _e1868 = local_27[2u];
let _e1872 = local_27[2u];
let _e1879 = global_1.member.member_8.member_6;
let _e1883 = global_1.member.member_8.member_5;
let _e1885 = (((_e1802 + ((_e1806 - _e1802) * _e1872)) - _e1879) * _e1883);
let _e1886 = -(1e9f);
let _e1888 = select(_e1886, _e1885, (_e1885 > _e1886));
let _e1890 = select(1e9f, _e1888, (_e1888 < 1e9f));
let _e1892 = (((_e1810 + (((_e1536 + (((_e1555 + ((_e1565 - _e1555) * _e1586)) - _e1536) * _e1811)) - _e1810) * _e1816)) - _e1879) * _e1883);
let _e1894 = select(_e1886, _e1892, (_e1892 > _e1886));
let _e1896 = select(1e9f, _e1894, (_e1894 < 1e9f));
let _e1898 = (((_e1823 + (((_e1544 + (((_e1575 + ((bitcast<f32>(_e1584) - _e1575) * _e1594)) - _e1544) * _e1824)) - _e1823) * _e1828)) - _e1879) * _e1883);
let _e1900 = select(_e1886, _e1898, (_e1898 > _e1886));
let _e1902 = select(1e9f, _e1900, (_e1900 < 1e9f));
let _e1904 = (((_e1835 + (((_e1672 + ((_e1540 - _e1672) * _e1836)) - _e1835) * _e1840)) - _e1879) * _e1883);
let _e1906 = select(_e1886, _e1904, (_e1904 > _e1886));
let _e1908 = select(1e9f, _e1906, (_e1906 < 1e9f));
let _e1910 = (((_e1847 + (((_e1593 + (((_e1683 + ((bitcast<f32>(_e1692) - _e1683) * _e1694)) - _e1593) * _e1848)) - _e1847) * _e1852)) - _e1879) * _e1883);
let _e1912 = select(_e1886, _e1910, (_e1910 > _e1886));
let _e1914 = select(1e9f, _e1912, (_e1912 < 1e9f));
let _e1916 = (((_e1859 + ((_e1802 - _e1859) * _e1860)) - _e1879) * _e1883);
let _e1918 = select(_e1886, _e1916, (_e1916 > _e1886));
let _e1920 = select(1e9f, _e1918, (_e1918 < 1e9f));
let _e1922 = (((_e1806 + (((_e1747 + (((_e1783 + ((bitcast<f32>(_e1792) - _e1783) * _e1794)) - _e1747) * _e1864)) - _e1806) * _e1868)) - _e1879) * _e1883);
let _e1924 = select(_e1886, _e1922, (_e1922 > _e1886));
let _e1926 = select(1e9f, _e1924, (_e1924 < 1e9f));
local_24 = _e1890;
let _e1927 = local_24;
local_25 = _e1927;
let _e1928 = local_25;
let _e1930 = (bitcast<i32>(_e165) - 1i);
let _e1932 = select(_e1930, 263197i, (263197i < _e1930));
let _e1937 = global_3.member[bitcast<u32>(select(0i, _e1932, (_e1932 > 0i)))];
let _e1938 = bitcast<f32>(_e1937);
let _e1940 = select(_e1930, 263198i, (263198i < _e1930));
let _e1943 = bitcast<u32>(select(0i, _e1940, (_e1940 > 0i)));
let _e1945 = global_3.member[_e1943];
let _e1946 = bitcast<f32>(_e1945);
let _e1948 = select(_e1930, 263199i, (263199i < _e1930));
let _e1953 = global_3.member[bitcast<u32>(select(0i, _e1948, (_e1948 > 0i)))];
let _e1954 = bitcast<f32>(_e1953);
let _e1956 = ((_e1928 - _e1938) * _e1946);
let _e1958 = select(0f, _e1956, (_e1956 > 0f));
let _e1961 = local_25;
let _e1963 = select(_e1930, 263200i, (263200i < _e1930));
let _e1968 = global_3.member[bitcast<u32>(select(0i, _e1963, (_e1963 > 0i)))];
let _e1969 = bitcast<f32>(_e1968);
let _e1971 = select(_e1930, 263201i, (263201i < _e1930));
let _e1976 = global_3.member[bitcast<u32>(select(0i, _e1971, (_e1971 > 0i)))];
let _e1977 = bitcast<f32>(_e1976);
let _e1979 = select(_e1930, 263202i, (263202i < _e1930));
let _e1984 = global_3.member[bitcast<u32>(select(0i, _e1979, (_e1979 > 0i)))];
let _e1985 = bitcast<f32>(_e1984);
let _e1987 = ((_e1961 - _e1969) * _e1977);
let _e1989 = select(0f, _e1987, (_e1987 > 0f));
let _e1993 = local_25;
let _e1995 = select(_e1930, 263203i, (263203i < _e1930));
let _e2000 = global_3.member[bitcast<u32>(select(0i, _e1995, (_e1995 > 0i)))];
let _e2001 = bitcast<f32>(_e2000);
let _e2003 = select(_e1930, 263204i, (263204i < _e1930));
let _e2008 = global_3.member[bitcast<u32>(select(0i, _e2003, (_e2003 > 0i)))];
let _e2009 = bitcast<f32>(_e2008);
let _e2011 = select(_e1930, 263205i, (263205i < _e1930));
let _e2016 = global_3.member[bitcast<u32>(select(0i, _e2011, (_e2011 > 0i)))];
let _e2017 = bitcast<f32>(_e2016);
let _e2019 = ((_e1993 - _e2001) * _e2009);
let _e2021 = select(0f, _e2019, (_e2019 > 0f));
let _e2024 = local_25;
let _e2026 = select(_e1930, 263206i, (263206i < _e1930));
let _e2031 = global_3.member[bitcast<u32>(select(0i, _e2026, (_e2026 > 0i)))];
let _e2032 = bitcast<f32>(_e2031);
let _e2034 = select(_e1930, 263207i, (263207i < _e1930));
let _e2039 = global_3.member[bitcast<u32>(select(0i, _e2034, (_e2034 > 0i)))];
let _e2040 = bitcast<f32>(_e2039);
let _e2042 = select(_e1930, 263208i, (263208i < _e1930));
let _e2047 = global_3.member[bitcast<u32>(select(0i, _e2042, (_e2042 > 0i)))];
let _e2048 = bitcast<f32>(_e2047);
let _e2050 = ((_e2024 - _e2032) * _e2040);
let _e2052 = select(0f, _e2050, (_e2050 > 0f));
let _e2056 = ((select(_e1954, _e1958, (_e1958 < _e1954)) + select(_e1985, _e1989, (_e1989 < _e1985))) + (select(_e2017, _e2021, (_e2021 < _e2017)) + select(_e2048, _e2052, (_e2052 < _e2048))));
let _e2058 = select(0f, _e2056, (_e2056 > 0f));
let _e2060 = select(1023f, _e2058, (_e2058 < 1023f));
let _e2067 = select(0i, select(select(i32(_e2060), i32(-2147483648), (_e2060 < -2147483600f)), 2147483647i, (_e2060 > 2147483500f)), (_e2060 == _e2060));
let _e2071 = (_e2067 - select(0i, 1i, (_e2060 < f32(_e2067))));
let _e2072 = (262147i + _e2071);
let _e2074 = select(_e1930, _e2072, (_e2072 < _e1930));
let _e2080 = global_3.member[bitcast<u32>(select(0i, _e2074, (_e2074 > 0i)))];
let _e2090 = select(_e1930, 262146i, (262146i < _e1930));
let _e2096 = global_3.member[bitcast<u32>(select(0i, _e2090, (_e2090 > 0i)))];
let _e2097 = bitcast<f32>(_e2096);
let _e2098 = (f32((bitcast<i32>((_e2080 & 4095u)) - 2048i)) * _e2097);
let _e2100 = select(_e1930, 262144i, (262144i < _e1930));
let _e2106 = global_3.member[bitcast<u32>(select(0i, _e2100, (_e2100 > 0i)))];
let _e2107 = bitcast<f32>(_e2106);
let _e2109 = select(_e1930, 262145i, (262145i < _e1930));
let _e2115 = global_3.member[bitcast<u32>(select(0i, _e2109, (_e2109 > 0i)))];
let _e2116 = bitcast<f32>(_e2115);
let _e2122 = ((_e2107 + (f32(bitcast<i32>((_e2080 >> bitcast<u32>(12u)))) * _e2116)) + (_e2098 * (_e2056 - f32(_e2071))));
let _e2125 = global_3.member[_e1943];
let _e2127 = local_24;
let _e2130 = local_24;
let _e2133 = local_24;
let _e2137 = select(_e1930, 263209i, (263209i < _e1930));
let _e2143 = global_3.member[bitcast<u32>(select(0i, _e2137, (_e2137 > 0i)))];
let _e2145 = local_24;
let _e2148 = select(_e1930, 263210i, (263210i < _e1930));
let _e2154 = global_3.member[bitcast<u32>(select(0i, _e2148, (_e2148 > 0i)))];
let _e2156 = local_24;
let _e2160 = (_e2098 * select(0f, select(select(select(bitcast<f32>(_e2125), _e1977, (_e2127 >= _e1969)), _e2009, (_e2130 >= _e2001)), _e2040, (_e2133 >= _e2032)), ((_e2145 >= bitcast<f32>(_e2143)) && (_e2156 <= bitcast<f32>(_e2154)))));
if _e1228 {
let _e2167 = ((0.5f * (_e1902 - _e1896)) * _e2160);
let _e2168 = ((0.5f * (_e1914 - _e1908)) * _e2160);
let _e2169 = ((0.5f * (_e1926 - _e1920)) * _e2160);
phi_6993_ = type_32(_e2122, vec3<f32>(_e2167, _e2168, _e2169), vec3<f32>((_e2167 * _e2122), (_e2168 * _e2122), (_e2169 * _e2122)));
} else {
local_22 = _e1896;
let _e2176 = local_22;
local_23 = _e2176;
let _e2177 = local_23;
let _e2179 = ((_e2177 - _e1938) * _e1946);
let _e2181 = select(0f, _e2179, (_e2179 > 0f));
let _e2184 = local_23;
let _e2186 = ((_e2184 - _e1969) * _e1977);
let _e2188 = select(0f, _e2186, (_e2186 > 0f));
let _e2192 = local_23;
let _e2194 = ((_e2192 - _e2001) * _e2009);
let _e2196 = select(0f, _e2194, (_e2194 > 0f));
let _e2199 = local_23;
let _e2201 = ((_e2199 - _e2032) * _e2040);
let _e2203 = select(0f, _e2201, (_e2201 > 0f));
let _e2207 = ((select(_e1954, _e2181, (_e2181 < _e1954)) + select(_e1985, _e2188, (_e2188 < _e1985))) + (select(_e2017, _e2196, (_e2196 < _e2017)) + select(_e2048, _e2203, (_e2203 < _e2048))));
let _e2209 = select(0f, _e2207, (_e2207 > 0f));
let _e2211 = select(1023f, _e2209, (_e2209 < 1023f));
let _e2218 = select(0i, select(select(i32(_e2211), i32(-2147483648), (_e2211 < -2147483600f)), 2147483647i, (_e2211 > 2147483500f)), (_e2211 == _e2211));
let _e2222 = (_e2218 - select(0i, 1i, (_e2211 < f32(_e2218))));
let _e2223 = (262147i + _e2222);
let _e2225 = select(_e1930, _e2223, (_e2223 < _e1930));
let _e2231 = global_3.member[bitcast<u32>(select(0i, _e2225, (_e2225 > 0i)))];
let _e2246 = ((_e2107 + (f32(bitcast<i32>((_e2231 >> bitcast<u32>(12u)))) * _e2116)) + ((f32((bitcast<i32>((_e2231 & 4095u)) - 2048i)) * _e2097) * (_e2207 - f32(_e2222))));
local_20 = _e1902;
let _e2247 = local_20;
local_21 = _e2247;
let _e2248 = local_21;
let _e2250 = ((_e2248 - _e1938) * _e1946);
let _e2252 = select(0f, _e2250, (_e2250 > 0f));
let _e2255 = local_21;
let _e2257 = ((_e2255 - _e1969) * _e1977);
let _e2259 = select(0f, _e2257, (_e2257 > 0f));
let _e2263 = local_21;
let _e2265 = ((_e2263 - _e2001) * _e2009);
let _e2267 = select(0f, _e2265, (_e2265 > 0f));
let _e2270 = local_21;
let _e2272 = ((_e2270 - _e2032) * _e2040);
let _e2274 = select(0f, _e2272, (_e2272 > 0f));
let _e2278 = ((select(_e1954, _e2252, (_e2252 < _e1954)) + select(_e1985, _e2259, (_e2259 < _e1985))) + (select(_e2017, _e2267, (_e2267 < _e2017)) + select(_e2048, _e2274, (_e2274 < _e2048))));
let _e2280 = select(0f, _e2278, (_e2278 > 0f));
let _e2282 = select(1023f, _e2280, (_e2280 < 1023f));
let _e2289 = select(0i, select(select(i32(_e2282), i32(-2147483648), (_e2282 < -2147483600f)), 2147483647i, (_e2282 > 2147483500f)), (_e2282 == _e2282));
let _e2293 = (_e2289 - select(0i, 1i, (_e2282 < f32(_e2289))));
let _e2294 = (262147i + _e2293);
let _e2296 = select(_e1930, _e2294, (_e2294 < _e1930));
let _e2302 = global_3.member[bitcast<u32>(select(0i, _e2296, (_e2296 > 0i)))];
let _e2317 = ((_e2107 + (f32(bitcast<i32>((_e2302 >> bitcast<u32>(12u)))) * _e2116)) + ((f32((bitcast<i32>((_e2302 & 4095u)) - 2048i)) * _e2097) * (_e2278 - f32(_e2293))));
local_18 = _e1908;
let _e2318 = local_18;
local_19 = _e2318;
let _e2319 = local_19;
let _e2321 = ((_e2319 - _e1938) * _e1946);
let _e2323 = select(0f, _e2321, (_e2321 > 0f));
let _e2326 = local_19;
let _e2328 = ((_e2326 - _e1969) * _e1977);
let _e2330 = select(0f, _e2328, (_e2328 > 0f));
let _e2334 = local_19;
let _e2336 = ((_e2334 - _e2001) * _e2009);
let _e2338 = select(0f, _e2336, (_e2336 > 0f));
let _e2341 = local_19;
let _e2343 = ((_e2341 - _e2032) * _e2040);
let _e2345 = select(0f, _e2343, (_e2343 > 0f));
let _e2349 = ((select(_e1954, _e2323, (_e2323 < _e1954)) + select(_e1985, _e2330, (_e2330 < _e1985))) + (select(_e2017, _e2338, (_e2338 < _e2017)) + select(_e2048, _e2345, (_e2345 < _e2048))));
let _e2351 = select(0f, _e2349, (_e2349 > 0f));
let _e2353 = select(1023f, _e2351, (_e2351 < 1023f));
let _e2360 = select(0i, select(select(i32(_e2353), i32(-2147483648), (_e2353 < -2147483600f)), 2147483647i, (_e2353 > 2147483500f)), (_e2353 == _e2353));
let _e2364 = (_e2360 - select(0i, 1i, (_e2353 < f32(_e2360))));
let _e2365 = (262147i + _e2364);
let _e2367 = select(_e1930, _e2365, (_e2365 < _e1930));
let _e2373 = global_3.member[bitcast<u32>(select(0i, _e2367, (_e2367 > 0i)))];
let _e2388 = ((_e2107 + (f32(bitcast<i32>((_e2373 >> bitcast<u32>(12u)))) * _e2116)) + ((f32((bitcast<i32>((_e2373 & 4095u)) - 2048i)) * _e2097) * (_e2349 - f32(_e2364))));
local_16 = _e1914;
let _e2389 = local_16;
local_17 = _e2389;
let _e2390 = local_17;
let _e2392 = ((_e2390 - _e1938) * _e1946);
let _e2394 = select(0f, _e2392, (_e2392 > 0f));
let _e2397 = local_17;
let _e2399 = ((_e2397 - _e1969) * _e1977);
let _e2401 = select(0f, _e2399, (_e2399 > 0f));
let _e2405 = local_17;
let _e2407 = ((_e2405 - _e2001) * _e2009);
let _e2409 = select(0f, _e2407, (_e2407 > 0f));
let _e2412 = local_17;
let _e2414 = ((_e2412 - _e2032) * _e2040);
let _e2416 = select(0f, _e2414, (_e2414 > 0f));
let _e2420 = ((select(_e1954, _e2394, (_e2394 < _e1954)) + select(_e1985, _e2401, (_e2401 < _e1985))) + (select(_e2017, _e2409, (_e2409 < _e2017)) + select(_e2048, _e2416, (_e2416 < _e2048))));
let _e2422 = select(0f, _e2420, (_e2420 > 0f));
let _e2424 = select(1023f, _e2422, (_e2422 < 1023f));
let _e2431 = select(0i, select(select(i32(_e2424), i32(-2147483648), (_e2424 < -2147483600f)), 2147483647i, (_e2424 > 2147483500f)), (_e2424 == _e2424));
let _e2435 = (_e2431 - select(0i, 1i, (_e2424 < f32(_e2431))));
let _e2436 = (262147i + _e2435);
let _e2438 = select(_e1930, _e2436, (_e2436 < _e1930));
let _e2444 = global_3.member[bitcast<u32>(select(0i, _e2438, (_e2438 > 0i)))];
let _e2459 = ((_e2107 + (f32(bitcast<i32>((_e2444 >> bitcast<u32>(12u)))) * _e2116)) + ((f32((bitcast<i32>((_e2444 & 4095u)) - 2048i)) * _e2097) * (_e2420 - f32(_e2435))));
local_14 = _e1920;
let _e2460 = local_14;
local_15 = _e2460;
let _e2461 = local_15;
let _e2463 = ((_e2461 - _e1938) * _e1946);
let _e2465 = select(0f, _e2463, (_e2463 > 0f));
let _e2468 = local_15;
let _e2470 = ((_e2468 - _e1969) * _e1977);
let _e2472 = select(0f, _e2470, (_e2470 > 0f));
let _e2476 = local_15;
let _e2478 = ((_e2476 - _e2001) * _e2009);
let _e2480 = select(0f, _e2478, (_e2478 > 0f));
let _e2483 = local_15;
let _e2485 = ((_e2483 - _e2032) * _e2040);
let _e2487 = select(0f, _e2485, (_e2485 > 0f));
let _e2491 = ((select(_e1954, _e2465, (_e2465 < _e1954)) + select(_e1985, _e2472, (_e2472 < _e1985))) + (select(_e2017, _e2480, (_e2480 < _e2017)) + select(_e2048, _e2487, (_e2487 < _e2048))));
let _e2493 = select(0f, _e2491, (_e2491 > 0f));
let _e2495 = select(1023f, _e2493, (_e2493 < 1023f));
let _e2502 = select(0i, select(select(i32(_e2495), i32(-2147483648), (_e2495 < -2147483600f)), 2147483647i, (_e2495 > 2147483500f)), (_e2495 == _e2495));
let _e2506 = (_e2502 - select(0i, 1i, (_e2495 < f32(_e2502))));
let _e2507 = (262147i + _e2506);
let _e2509 = select(_e1930, _e2507, (_e2507 < _e1930));
let _e2515 = global_3.member[bitcast<u32>(select(0i, _e2509, (_e2509 > 0i)))];
let _e2530 = ((_e2107 + (f32(bitcast<i32>((_e2515 >> bitcast<u32>(12u)))) * _e2116)) + ((f32((bitcast<i32>((_e2515 & 4095u)) - 2048i)) * _e2097) * (_e2491 - f32(_e2506))));
local_12 = _e1926;
let _e2531 = local_12;
local_13 = _e2531;
let _e2532 = local_13;
let _e2534 = ((_e2532 - _e1938) * _e1946);
let _e2536 = select(0f, _e2534, (_e2534 > 0f));
let _e2539 = local_13;
let _e2541 = ((_e2539 - _e1969) * _e1977);
let _e2543 = select(0f, _e2541, (_e2541 > 0f));
let _e2547 = local_13;
let _e2549 = ((_e2547 - _e2001) * _e2009);
let _e2551 = select(0f, _e2549, (_e2549 > 0f));
let _e2554 = local_13;
let _e2556 = ((_e2554 - _e2032) * _e2040);
let _e2558 = select(0f, _e2556, (_e2556 > 0f));
let _e2562 = ((select(_e1954, _e2536, (_e2536 < _e1954)) + select(_e1985, _e2543, (_e2543 < _e1985))) + (select(_e2017, _e2551, (_e2551 < _e2017)) + select(_e2048, _e2558, (_e2558 < _e2048))));
let _e2564 = select(0f, _e2562, (_e2562 > 0f));
let _e2566 = select(1023f, _e2564, (_e2564 < 1023f));
let _e2573 = select(0i, select(select(i32(_e2566), i32(-2147483648), (_e2566 < -2147483600f)), 2147483647i, (_e2566 > 2147483500f)), (_e2566 == _e2566));
let _e2577 = (_e2573 - select(0i, 1i, (_e2566 < f32(_e2573))));
let _e2578 = (262147i + _e2577);
let _e2580 = select(_e1930, _e2578, (_e2578 < _e1930));
let _e2586 = global_3.member[bitcast<u32>(select(0i, _e2580, (_e2580 > 0i)))];
let _e2601 = ((_e2107 + (f32(bitcast<i32>((_e2586 >> bitcast<u32>(12u)))) * _e2116)) + ((f32((bitcast<i32>((_e2586 & 4095u)) - 2048i)) * _e2097) * (_e2562 - f32(_e2577))));
let _e2602 = (_e2317 - _e2246);
let _e2604 = (_e2459 - _e2388);
let _e2606 = (_e2601 - _e2530);
phi_6993_ = type_32(_e2122, vec3<f32>((0.5f * _e2602), (0.5f * _e2604), (0.5f * _e2606)), vec3<f32>((0.25f * (_e2602 * (_e2317 + _e2246))), (0.25f * (_e2604 * (_e2459 + _e2388))), (0.25f * (_e2606 * (_e2601 + _e2530)))));
}
let _e2621 = phi_6993_;
let _e2636 = select(0f, 1f, ((((((_e1208 >= -0.5f) && (_e1208 <= _e1235)) && (_e1214 >= -0.5f)) && (_e1214 <= _e1245)) && (_e1220 >= -0.5f)) && (_e1220 <= _e1255)));
let _e2638 = (0.5f * (_e1902 - _e1896));
let _e2640 = (0.5f * (_e1914 - _e1908));
let _e2642 = (0.5f * (_e1926 - _e1920));
let _e2648 = global_1.member.member_8.member.member.member;
let _e2654 = global_1.member.member_8.member.member.member_1;
let _e2660 = global_1.member.member_8.member.member.member_2;
let _e2666 = global_1.member.member_8.member_1.member.member;
let _e2672 = global_1.member.member_8.member_1.member.member_1;
let _e2678 = global_1.member.member_8.member_1.member.member_2;
let _e2684 = global_1.member.member_8.member_2.member.member;
let _e2690 = global_1.member.member_8.member_2.member.member_1;
let _e2696 = global_1.member.member_8.member_2.member.member_2;
phi_7603_ = type_33(_e1890, vec3<f32>(((((_e2648 * _e2638) + (_e2666 * _e2640)) + (_e2684 * _e2642)) * _e2636), ((((_e2654 * _e2638) + (_e2672 * _e2640)) + (_e2690 * _e2642)) * _e2636), ((((_e2660 * _e2638) + (_e2678 * _e2640)) + (_e2696 * _e2642)) * _e2636)), _e2621.member, vec3<f32>(((((_e2648 * _e2621.member_2.x) + (_e2666 * _e2621.member_2.y)) + (_e2684 * _e2621.member_2.z)) * _e2636), ((((_e2654 * _e2621.member_2.x) + (_e2672 * _e2621.member_2.y)) + (_e2690 * _e2621.member_2.z)) * _e2636), ((((_e2660 * _e2621.member_2.x) + (_e2678 * _e2621.member_2.y)) + (_e2696 * _e2621.member_2.z)) * _e2636)), vec3<f32>(((((_e2648 * _e2621.member_1.x) + (_e2666 * _e2621.member_1.y)) + (_e2684 * _e2621.member_1.z)) * _e2636), ((((_e2654 * _e2621.member_1.x) + (_e2672 * _e2621.member_1.y)) + (_e2690 * _e2621.member_1.z)) * _e2636), ((((_e2660 * _e2621.member_1.x) + (_e2678 * _e2621.member_1.y)) + (_e2696 * _e2621.member_1.z)) * _e2636)));
} else {
let _e2765 = global_1.member.member_8.member_3.member;
let _e2766 = (_e2765 - 0.5f);
let _e2768 = select(-0.5f, _e1208, (_e1208 > -0.5f));
let _e2770 = select(_e2766, _e2768, (_e2768 < _e2766));
let _e2775 = global_1.member.member_8.member_3.member_1;
let _e2776 = (_e2775 - 0.5f);
let _e2778 = select(-0.5f, _e1214, (_e1214 > -0.5f));
let _e2780 = select(_e2776, _e2778, (_e2778 < _e2776));
let _e2785 = global_1.member.member_8.member_3.member_2;
let _e2786 = (_e2785 - 0.5f);
let _e2788 = select(-0.5f, _e1220, (_e1220 > -0.5f));
let _e2790 = select(_e2786, _e2788, (_e2788 < _e2786));
let _e2792 = select(-1f, _e2770, (_e2770 > -1f));
let _e2794 = select(_e2765, _e2792, (_e2792 < _e2765));
let _e2801 = select(0i, select(select(i32(_e2794), i32(-2147483648), (_e2794 < -2147483600f)), 2147483647i, (_e2794 > 2147483500f)), (_e2794 == _e2794));
let _e2805 = (_e2801 - select(0i, 1i, (_e2794 < f32(_e2801))));
let _e2807 = select(-1f, _e2780, (_e2780 > -1f));
let _e2809 = select(_e2775, _e2807, (_e2807 < _e2775));
let _e2816 = select(0i, select(select(i32(_e2809), i32(-2147483648), (_e2809 < -2147483600f)), 2147483647i, (_e2809 > 2147483500f)), (_e2809 == _e2809));
let _e2820 = (_e2816 - select(0i, 1i, (_e2809 < f32(_e2816))));
let _e2822 = select(-1f, _e2790, (_e2790 > -1f));
let _e2824 = select(_e2785, _e2822, (_e2822 < _e2785));
let _e2831 = select(0i, select(select(i32(_e2824), i32(-2147483648), (_e2824 < -2147483600f)), 2147483647i, (_e2824 > 2147483500f)), (_e2824 == _e2824));
let _e2835 = (_e2831 - select(0i, 1i, (_e2824 < f32(_e2831))));
let _e2839 = global_1.member.member_8.member_7;
let _e2843 = global_1.member.member_8.member_8;
let _e2844 = (_e2805 + 1i);
let _e2845 = (_e2820 + 1i);
let _e2846 = (_e2835 + 1i);
let _e2851 = global_1.member.member_8.member_11.member;
let _e2857 = global_1.member.member_8.member_11.member_1;
let _e2868 = ((_e2844 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2851) * ((_e2845 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2857) * (_e2846 >> bitcast<u32>(4i))))));
let _e2870 = (bitcast<i32>(_e160) - 1i);
let _e2872 = select(_e2870, _e2868, (_e2868 < _e2870));
let _e2878 = global_2.member[bitcast<u32>(select(0i, _e2872, (_e2872 > 0i)))];
let _e2880 = (_e2844 & 15i);
let _e2883 = ((_e2845 & 15i) * _e2839);
let _e2885 = (bitcast<i32>(_e2878) + ((_e2846 & 15i) * _e2843));
let _e2889 = (_e2883 + _e2839);
let _e2891 = (_e2883 + (2i * _e2839));
let _e2892 = (_e2885 + _e2843);
let _e2894 = (_e2885 + (2i * _e2843));
local_10 = type_29(array<i32, 4>(_e2880, (_e2880 + 1i), (_e2880 + 2i), (_e2880 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = vec3<f32>((_e2770 - f32(_e2805)), (_e2780 - f32(_e2820)), (_e2790 - f32(_e2835)));
let _e2905 = (_e2892 + _e2889);
let _e2908 = local_10.member[1u];
let _e2909 = (_e2905 + _e2908);
let _e2911 = select(_e2870, _e2909, (_e2909 < _e2870));
let _e2916 = global_2.member[bitcast<u32>(select(0i, _e2911, (_e2911 > 0i)))];
let _e2917 = bitcast<f32>(_e2916);
let _e2920 = local_10.member[2u];
let _e2921 = (_e2905 + _e2920);
let _e2923 = select(_e2870, _e2921, (_e2921 < _e2870));
let _e2928 = global_2.member[bitcast<u32>(select(0i, _e2923, (_e2923 > 0i)))];
let _e2930 = local_11[0u];
let _e2933 = (_e2917 + ((bitcast<f32>(_e2928) - _e2917) * _e2930));
let _e2934 = (_e2892 + _e2891);
let _e2935 = local_10.member[1u];
let _e2936 = (_e2934 + _e2935);
let _e2938 = select(_e2870, _e2936, (_e2936 < _e2870));
let _e2943 = global_2.member[bitcast<u32>(select(0i, _e2938, (_e2938 > 0i)))];
let _e2944 = bitcast<f32>(_e2943);
let _e2945 = local_10.member[2u];
let _e2946 = (_e2934 + _e2945);
let _e2948 = select(_e2870, _e2946, (_e2946 < _e2870));
let _e2953 = global_2.member[bitcast<u32>(select(0i, _e2948, (_e2948 > 0i)))];
let _e2955 = local_11[0u];
let _e2960 = local_11[1u];
let _e2963 = (_e2933 + (((_e2944 + ((bitcast<f32>(_e2953) - _e2944) * _e2955)) - _e2933) * _e2960));
let _e2964 = (_e2894 + _e2889);
let _e2965 = local_10.member[1u];
let _e2966 = (_e2964 + _e2965);
let _e2968 = select(_e2870, _e2966, (_e2966 < _e2870));
let _e2973 = global_2.member[bitcast<u32>(select(0i, _e2968, (_e2968 > 0i)))];
let _e2974 = bitcast<f32>(_e2973);
let _e2975 = local_10.member[2u];
let _e2976 = (_e2964 + _e2975);
let _e2978 = select(_e2870, _e2976, (_e2976 < _e2870));
let _e2983 = global_2.member[bitcast<u32>(select(0i, _e2978, (_e2978 > 0i)))];
let _e2985 = local_11[0u];
let _e2988 = (_e2974 + ((bitcast<f32>(_e2983) - _e2974) * _e2985));
let _e2989 = (_e2894 + _e2891);
let _e2990 = local_10.member[1u];
let _e2991 = (_e2989 + _e2990);
let _e2993 = select(_e2870, _e2991, (_e2991 < _e2870));
let _e2998 = global_2.member[bitcast<u32>(select(0i, _e2993, (_e2993 > 0i)))];
let _e2999 = bitcast<f32>(_e2998);
let _e3000 = local_10.member[2u];
let _e3001 = (_e2989 + _e3000);
let _e3003 = select(_e2870, _e3001, (_e3001 < _e2870));
let _e3008 = global_2.member[bitcast<u32>(select(0i, _e3003, (_e3003 > 0i)))];
let _e3010 = local_11[0u];
let _e3014 = local_11[1u];
let _e3019 = local_11[2u];
let _e3026 = global_1.member.member_8.member_6;
let _e3030 = global_1.member.member_8.member_5;
let _e3032 = (((_e2963 + (((_e2988 + (((_e2999 + ((bitcast<f32>(_e3008) - _e2999) * _e3010)) - _e2988) * _e3014)) - _e2963) * _e3019)) - _e3026) * _e3030);
let _e3033 = -(1e9f);
let _e3035 = select(_e3033, _e3032, (_e3032 > _e3033));
phi_7603_ = type_33(select(1e9f, _e3035, (_e3035 < 1e9f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e3040 = phi_7603_;
let _e3045 = global_1.member.member_8.member_3.member;
let _e3046 = (_e3045 - 0.5f);
let _e3048 = select(-0.5f, _e1172, (_e1172 > -0.5f));
let _e3050 = select(_e3046, _e3048, (_e3048 < _e3046));
let _e3055 = global_1.member.member_8.member_3.member_1;
let _e3056 = (_e3055 - 0.5f);
let _e3058 = select(-0.5f, _e1187, (_e1187 > -0.5f));
let _e3060 = select(_e3056, _e3058, (_e3058 < _e3056));
let _e3065 = global_1.member.member_8.member_3.member_2;
let _e3066 = (_e3065 - 0.5f);
let _e3068 = select(-0.5f, _e1202, (_e1202 > -0.5f));
let _e3070 = select(_e3066, _e3068, (_e3068 < _e3066));
let _e3072 = select(-1f, _e3050, (_e3050 > -1f));
let _e3074 = select(_e3045, _e3072, (_e3072 < _e3045));
let _e3081 = select(0i, select(select(i32(_e3074), i32(-2147483648), (_e3074 < -2147483600f)), 2147483647i, (_e3074 > 2147483500f)), (_e3074 == _e3074));
let _e3085 = (_e3081 - select(0i, 1i, (_e3074 < f32(_e3081))));
let _e3087 = select(-1f, _e3060, (_e3060 > -1f));
let _e3089 = select(_e3055, _e3087, (_e3087 < _e3055));
let _e3096 = select(0i, select(select(i32(_e3089), i32(-2147483648), (_e3089 < -2147483600f)), 2147483647i, (_e3089 > 2147483500f)), (_e3089 == _e3089));
let _e3100 = (_e3096 - select(0i, 1i, (_e3089 < f32(_e3096))));
let _e3102 = select(-1f, _e3070, (_e3070 > -1f));
let _e3104 = select(_e3065, _e3102, (_e3102 < _e3065));
let _e3111 = select(0i, select(select(i32(_e3104), i32(-2147483648), (_e3104 < -2147483600f)), 2147483647i, (_e3104 > 2147483500f)), (_e3104 == _e3104));
let _e3115 = (_e3111 - select(0i, 1i, (_e3104 < f32(_e3111))));
let _e3119 = global_1.member.member_8.member_7;
let _e3123 = global_1.member.member_8.member_8;
let _e3124 = (_e3085 + 1i);
let _e3125 = (_e3100 + 1i);
let _e3126 = (_e3115 + 1i);
let _e3131 = global_1.member.member_8.member_11.member;
let _e3132 = bitcast<i32>(_e3131);
let _e3137 = global_1.member.member_8.member_11.member_1;
let _e3138 = bitcast<i32>(_e3137);
let _e3148 = ((_e3124 >> bitcast<u32>(4i)) + (_e3132 * ((_e3125 >> bitcast<u32>(4i)) + (_e3138 * (_e3126 >> bitcast<u32>(4i))))));
let _e3150 = (bitcast<i32>(_e160) - 1i);
let _e3152 = select(_e3150, _e3148, (_e3148 < _e3150));
let _e3158 = global_2.member[bitcast<u32>(select(0i, _e3152, (_e3152 > 0i)))];
let _e3160 = (_e3124 & 15i);
let _e3163 = ((_e3125 & 15i) * _e3119);
let _e3165 = (bitcast<i32>(_e3158) + ((_e3126 & 15i) * _e3123));
let _e3169 = (_e3163 + _e3119);
let _e3170 = (2i * _e3119);
let _e3171 = (_e3163 + _e3170);
let _e3172 = (_e3165 + _e3123);
let _e3173 = (2i * _e3123);
let _e3174 = (_e3165 + _e3173);
local_8 = type_29(array<i32, 4>(_e3160, (_e3160 + 1i), (_e3160 + 2i), (_e3160 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = vec3<f32>((_e3050 - f32(_e3085)), (_e3060 - f32(_e3100)), (_e3070 - f32(_e3115)));
let _e3185 = (_e3172 + _e3169);
let _e3188 = local_8.member[1u];
let _e3189 = (_e3185 + _e3188);
let _e3191 = select(_e3150, _e3189, (_e3189 < _e3150));
let _e3196 = global_2.member[bitcast<u32>(select(0i, _e3191, (_e3191 > 0i)))];
let _e3197 = bitcast<f32>(_e3196);
let _e3200 = local_8.member[2u];
let _e3201 = (_e3185 + _e3200);
let _e3203 = select(_e3150, _e3201, (_e3201 < _e3150));
let _e3208 = global_2.member[bitcast<u32>(select(0i, _e3203, (_e3203 > 0i)))];
let _e3210 = local_9[0u];
let _e3213 = (_e3197 + ((bitcast<f32>(_e3208) - _e3197) * _e3210));
let _e3214 = (_e3172 + _e3171);
let _e3215 = local_8.member[1u];
let _e3216 = (_e3214 + _e3215);
let _e3218 = select(_e3150, _e3216, (_e3216 < _e3150));
let _e3223 = global_2.member[bitcast<u32>(select(0i, _e3218, (_e3218 > 0i)))];
let _e3224 = bitcast<f32>(_e3223);
let _e3225 = local_8.member[2u];
let _e3226 = (_e3214 + _e3225);
let _e3228 = select(_e3150, _e3226, (_e3226 < _e3150));
let _e3233 = global_2.member[bitcast<u32>(select(0i, _e3228, (_e3228 > 0i)))];
let _e3235 = local_9[0u];
let _e3240 = local_9[1u];
let _e3243 = (_e3213 + (((_e3224 + ((bitcast<f32>(_e3233) - _e3224) * _e3235)) - _e3213) * _e3240));
let _e3244 = (_e3174 + _e3169);
let _e3245 = local_8.member[1u];
let _e3246 = (_e3244 + _e3245);
let _e3248 = select(_e3150, _e3246, (_e3246 < _e3150));
let _e3253 = global_2.member[bitcast<u32>(select(0i, _e3248, (_e3248 > 0i)))];
let _e3254 = bitcast<f32>(_e3253);
let _e3255 = local_8.member[2u];
let _e3256 = (_e3244 + _e3255);
let _e3258 = select(_e3150, _e3256, (_e3256 < _e3150));
let _e3263 = global_2.member[bitcast<u32>(select(0i, _e3258, (_e3258 > 0i)))];
let _e3265 = local_9[0u];
let _e3268 = (_e3254 + ((bitcast<f32>(_e3263) - _e3254) * _e3265));
let _e3269 = (_e3174 + _e3171);
let _e3270 = local_8.member[1u];
let _e3271 = (_e3269 + _e3270);
let _e3273 = select(_e3150, _e3271, (_e3271 < _e3150));
let _e3278 = global_2.member[bitcast<u32>(select(0i, _e3273, (_e3273 > 0i)))];
let _e3279 = bitcast<f32>(_e3278);
let _e3280 = local_8.member[2u];
let _e3281 = (_e3269 + _e3280);
let _e3283 = select(_e3150, _e3281, (_e3281 < _e3150));
let _e3288 = global_2.member[bitcast<u32>(select(0i, _e3283, (_e3283 > 0i)))];
let _e3290 = local_9[0u];
let _e3294 = local_9[1u];
let _e3299 = local_9[2u];
let _e3306 = global_1.member.member_8.member_6;
let _e3310 = global_1.member.member_8.member_5;
let _e3312 = (((_e3243 + (((_e3268 + (((_e3279 + ((bitcast<f32>(_e3288) - _e3279) * _e3290)) - _e3268) * _e3294)) - _e3243) * _e3299)) - _e3306) * _e3310);
let _e3313 = -(1e9f);
let _e3315 = select(_e3313, _e3312, (_e3312 > _e3313));
let _e3317 = select(1e9f, _e3315, (_e3315 < 1e9f));
let _e3320 = global_1.member.member_1;
let _e3322 = ((_e3320 & 16u) == 0u);
if _e3322 {
phi_8400_ = type_7(1f, 1f, 1f);
} else {
let _e3326 = global_1.member.member_16.member;
let _e3337 = ((((_e3326.member.member * _e1129) + (_e3326.member.member_1 * _e1142)) + (_e3326.member.member_2 * _e1107)) + _e3326.member_1);
let _e3343 = ((((_e3326.member.member * _e1152) + (_e3326.member.member_1 * _e1157)) + (_e3326.member.member_2 * _e1146)) + _e3326.member_1);
let _e3345 = select(_e3343, _e3337, (_e3337 < _e3343));
let _e3347 = select(_e3343, _e3337, (_e3337 > _e3343));
let _e3349 = (_e3347 - _e3345);
let _e3352 = (-(_e3345) / select(1e-30f, _e3349, (_e3349 > 1e-30f)));
let _e3354 = select(0f, _e3352, (_e3352 > 0f));
let _e3360 = select(select(select(1f, _e3354, (_e3354 < 1f)), 1f, (_e3347 <= 0f)), 0f, (_e3345 > 0f));
let _e3365 = global_1.member.member_16.member_1;
let _e3366 = (_e3365 != 0u);
let _e3376 = global_1.member.member_17.member;
let _e3387 = ((((_e3376.member.member * _e1129) + (_e3376.member.member_1 * _e1142)) + (_e3376.member.member_2 * _e1107)) + _e3376.member_1);
let _e3393 = ((((_e3376.member.member * _e1152) + (_e3376.member.member_1 * _e1157)) + (_e3376.member.member_2 * _e1146)) + _e3376.member_1);
let _e3395 = select(_e3393, _e3387, (_e3387 < _e3393));
let _e3397 = select(_e3393, _e3387, (_e3387 > _e3393));
let _e3399 = (_e3397 - _e3395);
let _e3402 = (-(_e3395) / select(1e-30f, _e3399, (_e3399 > 1e-30f)));
let _e3404 = select(0f, _e3402, (_e3402 > 0f));
let _e3410 = select(select(select(1f, _e3404, (_e3404 < 1f)), 1f, (_e3397 <= 0f)), 0f, (_e3395 > 0f));
let _e3415 = global_1.member.member_17.member_1;
let _e3416 = (_e3415 != 0u);
let _e3426 = global_1.member.member_18.member;
let _e3437 = ((((_e3426.member.member * _e1129) + (_e3426.member.member_1 * _e1142)) + (_e3426.member.member_2 * _e1107)) + _e3426.member_1);
let _e3443 = ((((_e3426.member.member * _e1152) + (_e3426.member.member_1 * _e1157)) + (_e3426.member.member_2 * _e1146)) + _e3426.member_1);
let _e3445 = select(_e3443, _e3437, (_e3437 < _e3443));
let _e3447 = select(_e3443, _e3437, (_e3437 > _e3443));
let _e3449 = (_e3447 - _e3445);
let _e3452 = (-(_e3445) / select(1e-30f, _e3449, (_e3449 > 1e-30f)));
let _e3454 = select(0f, _e3452, (_e3452 > 0f));
let _e3460 = select(select(select(1f, _e3454, (_e3454 < 1f)), 1f, (_e3447 <= 0f)), 0f, (_e3445 > 0f));
let _e3465 = global_1.member.member_18.member_1;
let _e3466 = (_e3465 != 0u);
let _e3476 = global_1.member.member_19.member;
let _e3487 = ((((_e3476.member.member * _e1129) + (_e3476.member.member_1 * _e1142)) + (_e3476.member.member_2 * _e1107)) + _e3476.member_1);
let _e3493 = ((((_e3476.member.member * _e1152) + (_e3476.member.member_1 * _e1157)) + (_e3476.member.member_2 * _e1146)) + _e3476.member_1);
let _e3495 = select(_e3493, _e3487, (_e3487 < _e3493));
let _e3497 = select(_e3493, _e3487, (_e3487 > _e3493));
let _e3499 = (_e3497 - _e3495);
let _e3502 = (-(_e3495) / select(1e-30f, _e3499, (_e3499 > 1e-30f)));
let _e3504 = select(0f, _e3502, (_e3502 > 0f));
let _e3510 = select(select(select(1f, _e3504, (_e3504 < 1f)), 1f, (_e3497 <= 0f)), 0f, (_e3495 > 0f));
let _e3515 = global_1.member.member_19.member_1;
let _e3516 = (_e3515 != 0u);
phi_8400_ = type_7(((((1f * _e3360) * _e3410) * _e3460) * _e3510), ((((1f * select(1f, _e3360, _e3366)) * select(1f, _e3410, _e3416)) * select(1f, _e3460, _e3466)) * select(1f, _e3510, _e3516)), ((((1f * select(1f, 0f, (_e3366 && (_e3343 > 0f)))) * select(1f, 0f, (_e3416 && (_e3393 > 0f)))) * select(1f, 0f, (_e3466 && (_e3443 > 0f)))) * select(1f, 0f, (_e3516 && (_e3493 > 0f)))));
}
let _e3525 = phi_8400_;
let _e3526 = (_e1208 - _e1172);
let _e3530 = (bitcast<f32>((bitcast<u32>(_e3526) & 2147483647u)) < 1e-12f);
let _e3532 = (1f / select(_e3526, 1f, _e3530));
let _e3533 = (-0.5f - _e1172);
let _e3534 = (_e3533 * _e3532);
let _e3536 = ((_e3046 - _e1172) * _e3532);
let _e3542 = select(_e3536, _e3534, (_e3534 < _e3536));
let _e3544 = select(0f, _e3542, (_e3542 > 0f));
let _e3547 = select(select(1f, _e3544, (_e3544 < 1f)), select(2f, 0f, ((_e1172 >= -0.5f) && (_e1172 <= _e3046))), _e3530);
let _e3549 = select(_e3536, _e3534, (_e3534 > _e3536));
let _e3551 = select(0f, _e3549, (_e3549 > 0f));
let _e3554 = select(select(1f, _e3551, (_e3551 < 1f)), 1f, _e3530);
let _e3555 = (_e1214 - _e1187);
let _e3559 = (bitcast<f32>((bitcast<u32>(_e3555) & 2147483647u)) < 1e-12f);
let _e3561 = (1f / select(_e3555, 1f, _e3559));
let _e3562 = (-0.5f - _e1187);
let _e3563 = (_e3562 * _e3561);
let _e3565 = ((_e3056 - _e1187) * _e3561);
let _e3571 = select(_e3565, _e3563, (_e3563 < _e3565));
let _e3573 = select(0f, _e3571, (_e3571 > 0f));
let _e3576 = select(select(1f, _e3573, (_e3573 < 1f)), select(2f, 0f, ((_e1187 >= -0.5f) && (_e1187 <= _e3056))), _e3559);
let _e3578 = select(_e3565, _e3563, (_e3563 > _e3565));
let _e3580 = select(0f, _e3578, (_e3578 > 0f));
let _e3583 = select(select(1f, _e3580, (_e3580 < 1f)), 1f, _e3559);
let _e3584 = (_e1220 - _e1202);
let _e3588 = (bitcast<f32>((bitcast<u32>(_e3584) & 2147483647u)) < 1e-12f);
let _e3590 = (1f / select(_e3584, 1f, _e3588));
let _e3591 = (-0.5f - _e1202);
let _e3592 = (_e3591 * _e3590);
let _e3594 = ((_e3066 - _e1202) * _e3590);
let _e3600 = select(_e3594, _e3592, (_e3592 < _e3594));
let _e3602 = select(0f, _e3600, (_e3600 > 0f));
let _e3605 = select(select(1f, _e3602, (_e3602 < 1f)), select(2f, 0f, ((_e1202 >= -0.5f) && (_e1202 <= _e3066))), _e3588);
let _e3607 = select(_e3594, _e3592, (_e3592 > _e3594));
let _e3609 = select(0f, _e3607, (_e3607 > 0f));
let _e3612 = select(select(1f, _e3609, (_e3609 < 1f)), 1f, _e3588);
let _e3614 = select(_e3583, _e3554, (_e3554 < _e3583));
let _e3618 = select(_e3576, _e3547, (_e3547 > _e3576));
let _e3621 = (select(_e3612, _e3614, (_e3614 < _e3612)) - select(_e3605, _e3618, (_e3618 > _e3605)));
let _e3624 = (_e1152 - _e1129);
let _e3625 = (_e1157 - _e1142);
let _e3626 = (_e1146 - _e1107);
let _e3631 = (((_e3624 * _e3624) + (_e3625 * _e3625)) + (_e3626 * _e3626));
let _e3639 = global_1.member.member_7.member_3;
let _e3640 = ((sqrt(select(0f, _e3631, (_e3631 > 0f))) * select(0f, _e3621, (_e3621 > 0f))) * _e3639);
if (((_e175.member_2 == 3u) || (_e175.member_2 == 4u)) || _e1222) {
local_7 = _e3317;
let _e3646 = local_7;
let _e3648 = (bitcast<i32>(_e165) - 1i);
let _e3650 = select(_e3648, 263171i, (263171i < _e3648));
let _e3655 = global_3.member[bitcast<u32>(select(0i, _e3650, (_e3650 > 0i)))];
let _e3656 = bitcast<f32>(_e3655);
let _e3658 = select(_e3648, 263172i, (263172i < _e3648));
let _e3663 = global_3.member[bitcast<u32>(select(0i, _e3658, (_e3658 > 0i)))];
let _e3664 = bitcast<f32>(_e3663);
let _e3666 = select(_e3648, 263173i, (263173i < _e3648));
let _e3671 = global_3.member[bitcast<u32>(select(0i, _e3666, (_e3666 > 0i)))];
let _e3672 = bitcast<f32>(_e3671);
let _e3674 = ((_e3646 - _e3656) * _e3664);
let _e3676 = select(0f, _e3674, (_e3674 > 0f));
let _e3679 = local_7;
let _e3681 = select(_e3648, 263174i, (263174i < _e3648));
let _e3686 = global_3.member[bitcast<u32>(select(0i, _e3681, (_e3681 > 0i)))];
let _e3687 = bitcast<f32>(_e3686);
let _e3689 = select(_e3648, 263175i, (263175i < _e3648));
let _e3694 = global_3.member[bitcast<u32>(select(0i, _e3689, (_e3689 > 0i)))];
let _e3695 = bitcast<f32>(_e3694);
let _e3697 = select(_e3648, 263176i, (263176i < _e3648));
let _e3702 = global_3.member[bitcast<u32>(select(0i, _e3697, (_e3697 > 0i)))];
let _e3703 = bitcast<f32>(_e3702);
let _e3705 = ((_e3679 - _e3687) * _e3695);
let _e3707 = select(0f, _e3705, (_e3705 > 0f));
let _e3711 = local_7;
let _e3713 = select(_e3648, 263177i, (263177i < _e3648));
let _e3718 = global_3.member[bitcast<u32>(select(0i, _e3713, (_e3713 > 0i)))];
let _e3719 = bitcast<f32>(_e3718);
let _e3721 = select(_e3648, 263178i, (263178i < _e3648));
let _e3726 = global_3.member[bitcast<u32>(select(0i, _e3721, (_e3721 > 0i)))];
let _e3727 = bitcast<f32>(_e3726);
let _e3729 = select(_e3648, 263179i, (263179i < _e3648));
let _e3734 = global_3.member[bitcast<u32>(select(0i, _e3729, (_e3729 > 0i)))];
let _e3735 = bitcast<f32>(_e3734);
let _e3737 = ((_e3711 - _e3719) * _e3727);
let _e3739 = select(0f, _e3737, (_e3737 > 0f));
let _e3742 = local_7;
let _e3744 = select(_e3648, 263180i, (263180i < _e3648));
let _e3749 = global_3.member[bitcast<u32>(select(0i, _e3744, (_e3744 > 0i)))];
let _e3750 = bitcast<f32>(_e3749);
let _e3752 = select(_e3648, 263181i, (263181i < _e3648));
let _e3757 = global_3.member[bitcast<u32>(select(0i, _e3752, (_e3752 > 0i)))];
let _e3758 = bitcast<f32>(_e3757);
let _e3760 = select(_e3648, 263182i, (263182i < _e3648));
let _e3765 = global_3.member[bitcast<u32>(select(0i, _e3760, (_e3760 > 0i)))];
let _e3766 = bitcast<f32>(_e3765);
let _e3768 = ((_e3742 - _e3750) * _e3758);
let _e3770 = select(0f, _e3768, (_e3768 > 0f));
let _e3775 = local_7;
let _e3777 = select(_e3648, 263183i, (263183i < _e3648));
let _e3782 = global_3.member[bitcast<u32>(select(0i, _e3777, (_e3777 > 0i)))];
let _e3783 = bitcast<f32>(_e3782);
let _e3785 = select(_e3648, 263184i, (263184i < _e3648));
let _e3790 = global_3.member[bitcast<u32>(select(0i, _e3785, (_e3785 > 0i)))];
let _e3791 = bitcast<f32>(_e3790);
let _e3793 = select(_e3648, 263185i, (263185i < _e3648));
let _e3798 = global_3.member[bitcast<u32>(select(0i, _e3793, (_e3793 > 0i)))];
let _e3799 = bitcast<f32>(_e3798);
let _e3801 = ((_e3775 - _e3783) * _e3791);
let _e3803 = select(0f, _e3801, (_e3801 > 0f));
let _e3806 = local_7;
let _e3808 = select(_e3648, 263186i, (263186i < _e3648));
let _e3813 = global_3.member[bitcast<u32>(select(0i, _e3808, (_e3808 > 0i)))];
let _e3814 = bitcast<f32>(_e3813);
let _e3816 = select(_e3648, 263187i, (263187i < _e3648));
let _e3821 = global_3.member[bitcast<u32>(select(0i, _e3816, (_e3816 > 0i)))];
let _e3822 = bitcast<f32>(_e3821);
let _e3824 = select(_e3648, 263188i, (263188i < _e3648));
let _e3829 = global_3.member[bitcast<u32>(select(0i, _e3824, (_e3824 > 0i)))];
let _e3830 = bitcast<f32>(_e3829);
let _e3832 = ((_e3806 - _e3814) * _e3822);
let _e3834 = select(0f, _e3832, (_e3832 > 0f));
let _e3838 = local_7;
let _e3840 = select(_e3648, 263189i, (263189i < _e3648));
let _e3845 = global_3.member[bitcast<u32>(select(0i, _e3840, (_e3840 > 0i)))];
let _e3846 = bitcast<f32>(_e3845);
let _e3848 = select(_e3648, 263190i, (263190i < _e3648));
let _e3853 = global_3.member[bitcast<u32>(select(0i, _e3848, (_e3848 > 0i)))];
let _e3854 = bitcast<f32>(_e3853);
let _e3856 = select(_e3648, 263191i, (263191i < _e3648));
let _e3861 = global_3.member[bitcast<u32>(select(0i, _e3856, (_e3856 > 0i)))];
let _e3862 = bitcast<f32>(_e3861);
let _e3864 = ((_e3838 - _e3846) * _e3854);
let _e3866 = select(0f, _e3864, (_e3864 > 0f));
let _e3869 = local_7;
let _e3871 = select(_e3648, 263192i, (263192i < _e3648));
let _e3876 = global_3.member[bitcast<u32>(select(0i, _e3871, (_e3871 > 0i)))];
let _e3877 = bitcast<f32>(_e3876);
let _e3879 = select(_e3648, 263193i, (263193i < _e3648));
let _e3884 = global_3.member[bitcast<u32>(select(0i, _e3879, (_e3879 > 0i)))];
let _e3885 = bitcast<f32>(_e3884);
let _e3887 = select(_e3648, 263194i, (263194i < _e3648));
let _e3892 = global_3.member[bitcast<u32>(select(0i, _e3887, (_e3887 > 0i)))];
let _e3893 = bitcast<f32>(_e3892);
let _e3895 = ((_e3869 - _e3877) * _e3885);
let _e3897 = select(0f, _e3895, (_e3895 > 0f));
let _e3902 = (((select(_e3672, _e3676, (_e3676 < _e3672)) + select(_e3703, _e3707, (_e3707 < _e3703))) + (select(_e3735, _e3739, (_e3739 < _e3735)) + select(_e3766, _e3770, (_e3770 < _e3766)))) + ((select(_e3799, _e3803, (_e3803 < _e3799)) + select(_e3830, _e3834, (_e3834 < _e3830))) + (select(_e3862, _e3866, (_e3866 < _e3862)) + select(_e3893, _e3897, (_e3897 < _e3893)))));
local_6 = _e3040.member;
let _e3903 = local_6;
let _e3905 = ((_e3903 - _e3656) * _e3664);
let _e3907 = select(0f, _e3905, (_e3905 > 0f));
let _e3910 = local_6;
let _e3912 = ((_e3910 - _e3687) * _e3695);
let _e3914 = select(0f, _e3912, (_e3912 > 0f));
let _e3918 = local_6;
let _e3920 = ((_e3918 - _e3719) * _e3727);
let _e3922 = select(0f, _e3920, (_e3920 > 0f));
let _e3925 = local_6;
let _e3927 = ((_e3925 - _e3750) * _e3758);
let _e3929 = select(0f, _e3927, (_e3927 > 0f));
let _e3934 = local_6;
let _e3936 = ((_e3934 - _e3783) * _e3791);
let _e3938 = select(0f, _e3936, (_e3936 > 0f));
let _e3941 = local_6;
let _e3943 = ((_e3941 - _e3814) * _e3822);
let _e3945 = select(0f, _e3943, (_e3943 > 0f));
let _e3949 = local_6;
let _e3951 = ((_e3949 - _e3846) * _e3854);
let _e3953 = select(0f, _e3951, (_e3951 > 0f));
let _e3956 = local_6;
let _e3958 = ((_e3956 - _e3877) * _e3885);
let _e3960 = select(0f, _e3958, (_e3958 > 0f));
let _e3965 = (((select(_e3672, _e3907, (_e3907 < _e3672)) + select(_e3703, _e3914, (_e3914 < _e3703))) + (select(_e3735, _e3922, (_e3922 < _e3735)) + select(_e3766, _e3929, (_e3929 < _e3766)))) + ((select(_e3799, _e3938, (_e3938 < _e3799)) + select(_e3830, _e3945, (_e3945 < _e3830))) + (select(_e3862, _e3953, (_e3953 < _e3862)) + select(_e3893, _e3960, (_e3960 < _e3893)))));
let _e3966 = (255f - 1f);
let _e3968 = select(0f, _e3902, (_e3902 > 0f));
let _e3970 = select(_e3966, _e3968, (_e3968 < _e3966));
let _e3977 = select(0i, select(select(i32(_e3970), i32(-2147483648), (_e3970 < -2147483600f)), 2147483647i, (_e3970 > 2147483500f)), (_e3970 == _e3970));
let _e3981 = (_e3977 - select(0i, 1i, (_e3970 < f32(_e3977))));
let _e3983 = select(0f, _e3965, (_e3965 > 0f));
let _e3985 = select(_e3966, _e3983, (_e3983 < _e3966));
let _e3992 = select(0i, select(select(i32(_e3985), i32(-2147483648), (_e3985 < -2147483600f)), 2147483647i, (_e3985 > 2147483500f)), (_e3985 == _e3985));
let _e3996 = (_e3992 - select(0i, 1i, (_e3985 < f32(_e3992))));
let _e3998 = select(_e3648, 263195i, (263195i < _e3648));
let _e4004 = global_3.member[bitcast<u32>(select(0i, _e3998, (_e3998 > 0i)))];
let _e4005 = bitcast<f32>(_e4004);
let _e4007 = select(_e3648, 263196i, (263196i < _e3648));
let _e4013 = global_3.member[bitcast<u32>(select(0i, _e4007, (_e4007 > 0i)))];
let _e4014 = bitcast<f32>(_e4013);
let _e4015 = (_e3040.member - _e3317);
let _e4021 = (1f / select(_e4015, 1f, (bitcast<f32>((bitcast<u32>(_e4015) & 2147483647u)) < 1e-20f)));
let _e4027 = ((select(_e4005, _e3040.member, (_e3040.member < _e4005)) - select(_e4005, _e3317, (_e3317 < _e4005))) * _e4021);
let _e4033 = ((select(_e4014, _e3040.member, (_e3040.member > _e4014)) - select(_e4014, _e3317, (_e3317 > _e4014))) * _e4021);
let _e4036 = (((_e3981 * 256i) + _e3996) * 4i);
let _e4040 = (_e3965 - f32(_e3996));
let _e4044 = select(_e3648, _e4036, (_e4036 < _e3648));
let _e4050 = global_3.member[bitcast<u32>(select(0i, _e4044, (_e4044 > 0i)))];
let _e4051 = (_e4036 + 4i);
let _e4053 = select(_e3648, _e4051, (_e4051 < _e3648));
let _e4059 = global_3.member[bitcast<u32>(select(0i, _e4053, (_e4053 > 0i)))];
let _e4060 = (_e4036 + 1024i);
let _e4062 = select(_e3648, _e4060, (_e4060 < _e3648));
let _e4068 = global_3.member[bitcast<u32>(select(0i, _e4062, (_e4062 > 0i)))];
let _e4069 = (_e4036 + 1028i);
let _e4071 = select(_e3648, _e4069, (_e4069 < _e3648));
let _e4077 = global_3.member[bitcast<u32>(select(0i, _e4071, (_e4071 > 0i)))];
let _e4079 = select(_e3648, 0i, (0i < _e3648));
let _e4085 = global_3.member[bitcast<u32>(select(0i, _e4079, (_e4079 > 0i)))];
let _e4087 = select(_e3648, 262140i, (262140i < _e3648));
let _e4093 = global_3.member[bitcast<u32>(select(0i, _e4087, (_e4087 > 0i)))];
let _e4098 = (bitcast<f32>(((_e4050 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4106 = (_e4098 + (((bitcast<f32>(((_e4059 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4098) * _e4040));
let _e4111 = (bitcast<f32>(((_e4068 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4137 = (((_e4106 + (((_e4111 + (((bitcast<f32>(((_e4077 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4111) * _e4040)) - _e4106) * (_e3902 - f32(_e3981)))) * (1f - (_e4027 + _e4033))) + (((bitcast<f32>(((_e4085 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4027) + ((bitcast<f32>(((_e4093 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4033)));
let _e4141 = -((_e4137 * (_e3640 * _e3525.member)));
let _e4143 = select(-87f, _e4141, (_e4141 > -87f));
let _e4145 = select(88f, _e4143, (_e4143 < 88f));
let _e4147 = ((_e4145 * 1.442695f) + 0.5f);
let _e4149 = select(-127f, _e4147, (_e4147 > -127f));
let _e4151 = select(128f, _e4149, (_e4149 < 128f));
let _e4158 = select(0i, select(select(i32(_e4151), i32(-2147483648), (_e4151 < -2147483600f)), 2147483647i, (_e4151 > 2147483500f)), (_e4151 == _e4151));
let _e4162 = (_e4158 - select(0i, 1i, (_e4151 < f32(_e4158))));
let _e4163 = f32(_e4162);
let _e4167 = ((_e4145 - (_e4163 * 0.6933594f)) - (_e4163 * -2.1219444e-4f));
let _e4187 = ((1f + (_e4167 * (1f + (_e4167 * (0.5f + (_e4167 * (0.16666667f + (_e4167 * (0.041666668f + (_e4167 * (0.008333334f + (_e4167 * (0.001388889f + (_e4167 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4162 + 127i)) << bitcast<u32>(23i))));
let _e4188 = (1f - _e4187);
phi_12128_ = type_35(_e4187, _e4188, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e4188 / select(1e-12f, _e4137, (_e4137 > 1e-12f))))));
} else {
local_5 = _e3317;
let _e4196 = local_5;
let _e4198 = (bitcast<i32>(_e165) - 1i);
let _e4200 = select(_e4198, 263171i, (263171i < _e4198));
let _e4205 = global_3.member[bitcast<u32>(select(0i, _e4200, (_e4200 > 0i)))];
let _e4206 = bitcast<f32>(_e4205);
let _e4208 = select(_e4198, 263172i, (263172i < _e4198));
let _e4213 = global_3.member[bitcast<u32>(select(0i, _e4208, (_e4208 > 0i)))];
let _e4214 = bitcast<f32>(_e4213);
let _e4216 = select(_e4198, 263173i, (263173i < _e4198));
let _e4221 = global_3.member[bitcast<u32>(select(0i, _e4216, (_e4216 > 0i)))];
let _e4222 = bitcast<f32>(_e4221);
let _e4224 = ((_e4196 - _e4206) * _e4214);
let _e4226 = select(0f, _e4224, (_e4224 > 0f));
let _e4229 = local_5;
let _e4231 = select(_e4198, 263174i, (263174i < _e4198));
let _e4236 = global_3.member[bitcast<u32>(select(0i, _e4231, (_e4231 > 0i)))];
let _e4237 = bitcast<f32>(_e4236);
let _e4239 = select(_e4198, 263175i, (263175i < _e4198));
let _e4244 = global_3.member[bitcast<u32>(select(0i, _e4239, (_e4239 > 0i)))];
let _e4245 = bitcast<f32>(_e4244);
let _e4247 = select(_e4198, 263176i, (263176i < _e4198));
let _e4252 = global_3.member[bitcast<u32>(select(0i, _e4247, (_e4247 > 0i)))];
let _e4253 = bitcast<f32>(_e4252);
let _e4255 = ((_e4229 - _e4237) * _e4245);
let _e4257 = select(0f, _e4255, (_e4255 > 0f));
let _e4261 = local_5;
let _e4263 = select(_e4198, 263177i, (263177i < _e4198));
let _e4268 = global_3.member[bitcast<u32>(select(0i, _e4263, (_e4263 > 0i)))];
let _e4269 = bitcast<f32>(_e4268);
let _e4271 = select(_e4198, 263178i, (263178i < _e4198));
let _e4276 = global_3.member[bitcast<u32>(select(0i, _e4271, (_e4271 > 0i)))];
let _e4277 = bitcast<f32>(_e4276);
let _e4279 = select(_e4198, 263179i, (263179i < _e4198));
let _e4284 = global_3.member[bitcast<u32>(select(0i, _e4279, (_e4279 > 0i)))];
let _e4285 = bitcast<f32>(_e4284);
let _e4287 = ((_e4261 - _e4269) * _e4277);
let _e4289 = select(0f, _e4287, (_e4287 > 0f));
let _e4292 = local_5;
let _e4294 = select(_e4198, 263180i, (263180i < _e4198));
let _e4299 = global_3.member[bitcast<u32>(select(0i, _e4294, (_e4294 > 0i)))];
let _e4300 = bitcast<f32>(_e4299);
let _e4302 = select(_e4198, 263181i, (263181i < _e4198));
let _e4307 = global_3.member[bitcast<u32>(select(0i, _e4302, (_e4302 > 0i)))];
let _e4308 = bitcast<f32>(_e4307);
let _e4310 = select(_e4198, 263182i, (263182i < _e4198));
let _e4315 = global_3.member[bitcast<u32>(select(0i, _e4310, (_e4310 > 0i)))];
let _e4316 = bitcast<f32>(_e4315);
let _e4318 = ((_e4292 - _e4300) * _e4308);
let _e4320 = select(0f, _e4318, (_e4318 > 0f));
let _e4325 = local_5;
let _e4327 = select(_e4198, 263183i, (263183i < _e4198));
let _e4332 = global_3.member[bitcast<u32>(select(0i, _e4327, (_e4327 > 0i)))];
let _e4333 = bitcast<f32>(_e4332);
let _e4335 = select(_e4198, 263184i, (263184i < _e4198));
let _e4340 = global_3.member[bitcast<u32>(select(0i, _e4335, (_e4335 > 0i)))];
let _e4341 = bitcast<f32>(_e4340);
let _e4343 = select(_e4198, 263185i, (263185i < _e4198));
let _e4348 = global_3.member[bitcast<u32>(select(0i, _e4343, (_e4343 > 0i)))];
let _e4349 = bitcast<f32>(_e4348);
let _e4351 = ((_e4325 - _e4333) * _e4341);
let _e4353 = select(0f, _e4351, (_e4351 > 0f));
let _e4356 = local_5;
let _e4358 = select(_e4198, 263186i, (263186i < _e4198));
let _e4363 = global_3.member[bitcast<u32>(select(0i, _e4358, (_e4358 > 0i)))];
let _e4364 = bitcast<f32>(_e4363);
let _e4366 = select(_e4198, 263187i, (263187i < _e4198));
let _e4371 = global_3.member[bitcast<u32>(select(0i, _e4366, (_e4366 > 0i)))];
let _e4372 = bitcast<f32>(_e4371);
let _e4374 = select(_e4198, 263188i, (263188i < _e4198));
let _e4379 = global_3.member[bitcast<u32>(select(0i, _e4374, (_e4374 > 0i)))];
let _e4380 = bitcast<f32>(_e4379);
let _e4382 = ((_e4356 - _e4364) * _e4372);
let _e4384 = select(0f, _e4382, (_e4382 > 0f));
let _e4388 = local_5;
let _e4390 = select(_e4198, 263189i, (263189i < _e4198));
let _e4395 = global_3.member[bitcast<u32>(select(0i, _e4390, (_e4390 > 0i)))];
let _e4396 = bitcast<f32>(_e4395);
let _e4398 = select(_e4198, 263190i, (263190i < _e4198));
let _e4403 = global_3.member[bitcast<u32>(select(0i, _e4398, (_e4398 > 0i)))];
let _e4404 = bitcast<f32>(_e4403);
let _e4406 = select(_e4198, 263191i, (263191i < _e4198));
let _e4411 = global_3.member[bitcast<u32>(select(0i, _e4406, (_e4406 > 0i)))];
let _e4412 = bitcast<f32>(_e4411);
let _e4414 = ((_e4388 - _e4396) * _e4404);
let _e4416 = select(0f, _e4414, (_e4414 > 0f));
let _e4419 = local_5;
let _e4421 = select(_e4198, 263192i, (263192i < _e4198));
let _e4426 = global_3.member[bitcast<u32>(select(0i, _e4421, (_e4421 > 0i)))];
let _e4427 = bitcast<f32>(_e4426);
let _e4429 = select(_e4198, 263193i, (263193i < _e4198));
let _e4434 = global_3.member[bitcast<u32>(select(0i, _e4429, (_e4429 > 0i)))];
let _e4435 = bitcast<f32>(_e4434);
let _e4437 = select(_e4198, 263194i, (263194i < _e4198));
let _e4442 = global_3.member[bitcast<u32>(select(0i, _e4437, (_e4437 > 0i)))];
let _e4443 = bitcast<f32>(_e4442);
let _e4445 = ((_e4419 - _e4427) * _e4435);
let _e4447 = select(0f, _e4445, (_e4445 > 0f));
let _e4452 = (((select(_e4222, _e4226, (_e4226 < _e4222)) + select(_e4253, _e4257, (_e4257 < _e4253))) + (select(_e4285, _e4289, (_e4289 < _e4285)) + select(_e4316, _e4320, (_e4320 < _e4316)))) + ((select(_e4349, _e4353, (_e4353 < _e4349)) + select(_e4380, _e4384, (_e4384 < _e4380))) + (select(_e4412, _e4416, (_e4416 < _e4412)) + select(_e4443, _e4447, (_e4447 < _e4443)))));
local_4 = _e3040.member;
let _e4453 = local_4;
let _e4455 = ((_e4453 - _e4206) * _e4214);
let _e4457 = select(0f, _e4455, (_e4455 > 0f));
let _e4460 = local_4;
let _e4462 = ((_e4460 - _e4237) * _e4245);
let _e4464 = select(0f, _e4462, (_e4462 > 0f));
let _e4468 = local_4;
let _e4470 = ((_e4468 - _e4269) * _e4277);
let _e4472 = select(0f, _e4470, (_e4470 > 0f));
let _e4475 = local_4;
let _e4477 = ((_e4475 - _e4300) * _e4308);
let _e4479 = select(0f, _e4477, (_e4477 > 0f));
let _e4484 = local_4;
let _e4486 = ((_e4484 - _e4333) * _e4341);
let _e4488 = select(0f, _e4486, (_e4486 > 0f));
let _e4491 = local_4;
let _e4493 = ((_e4491 - _e4364) * _e4372);
let _e4495 = select(0f, _e4493, (_e4493 > 0f));
let _e4499 = local_4;
let _e4501 = ((_e4499 - _e4396) * _e4404);
let _e4503 = select(0f, _e4501, (_e4501 > 0f));
let _e4506 = local_4;
let _e4508 = ((_e4506 - _e4427) * _e4435);
let _e4510 = select(0f, _e4508, (_e4508 > 0f));
let _e4515 = (((select(_e4222, _e4457, (_e4457 < _e4222)) + select(_e4253, _e4464, (_e4464 < _e4253))) + (select(_e4285, _e4472, (_e4472 < _e4285)) + select(_e4316, _e4479, (_e4479 < _e4316)))) + ((select(_e4349, _e4488, (_e4488 < _e4349)) + select(_e4380, _e4495, (_e4495 < _e4380))) + (select(_e4412, _e4503, (_e4503 < _e4412)) + select(_e4443, _e4510, (_e4510 < _e4443)))));
let _e4516 = (255f - 1f);
let _e4518 = select(0f, _e4452, (_e4452 > 0f));
let _e4520 = select(_e4516, _e4518, (_e4518 < _e4516));
let _e4527 = select(0i, select(select(i32(_e4520), i32(-2147483648), (_e4520 < -2147483600f)), 2147483647i, (_e4520 > 2147483500f)), (_e4520 == _e4520));
let _e4531 = (_e4527 - select(0i, 1i, (_e4520 < f32(_e4527))));
let _e4533 = select(0f, _e4515, (_e4515 > 0f));
let _e4535 = select(_e4516, _e4533, (_e4533 < _e4516));
let _e4542 = select(0i, select(select(i32(_e4535), i32(-2147483648), (_e4535 < -2147483600f)), 2147483647i, (_e4535 > 2147483500f)), (_e4535 == _e4535));
let _e4546 = (_e4542 - select(0i, 1i, (_e4535 < f32(_e4542))));
let _e4548 = select(_e4198, 263195i, (263195i < _e4198));
let _e4554 = global_3.member[bitcast<u32>(select(0i, _e4548, (_e4548 > 0i)))];
let _e4555 = bitcast<f32>(_e4554);
let _e4557 = select(_e4198, 263196i, (263196i < _e4198));
let _e4563 = global_3.member[bitcast<u32>(select(0i, _e4557, (_e4557 > 0i)))];
let _e4564 = bitcast<f32>(_e4563);
let _e4565 = (_e3040.member - _e3317);
let _e4571 = (1f / select(_e4565, 1f, (bitcast<f32>((bitcast<u32>(_e4565) & 2147483647u)) < 1e-20f)));
let _e4577 = ((select(_e4555, _e3040.member, (_e3040.member < _e4555)) - select(_e4555, _e3317, (_e3317 < _e4555))) * _e4571);
let _e4583 = ((select(_e4564, _e3040.member, (_e3040.member > _e4564)) - select(_e4564, _e3317, (_e3317 > _e4564))) * _e4571);
let _e4586 = (((_e4531 * 256i) + _e4546) * 4i);
let _e4588 = (_e4452 - f32(_e4531));
let _e4590 = (_e4515 - f32(_e4546));
let _e4592 = (1f - (_e4577 + _e4583));
let _e4594 = select(_e4198, _e4586, (_e4586 < _e4198));
let _e4600 = global_3.member[bitcast<u32>(select(0i, _e4594, (_e4594 > 0i)))];
let _e4601 = (_e4586 + 4i);
let _e4603 = select(_e4198, _e4601, (_e4601 < _e4198));
let _e4609 = global_3.member[bitcast<u32>(select(0i, _e4603, (_e4603 > 0i)))];
let _e4610 = (_e4586 + 1024i);
let _e4612 = select(_e4198, _e4610, (_e4610 < _e4198));
let _e4618 = global_3.member[bitcast<u32>(select(0i, _e4612, (_e4612 > 0i)))];
let _e4619 = (_e4586 + 1028i);
let _e4621 = select(_e4198, _e4619, (_e4619 < _e4198));
let _e4627 = global_3.member[bitcast<u32>(select(0i, _e4621, (_e4621 > 0i)))];
let _e4629 = select(_e4198, 0i, (0i < _e4198));
let _e4635 = global_3.member[bitcast<u32>(select(0i, _e4629, (_e4629 > 0i)))];
let _e4637 = select(_e4198, 262140i, (262140i < _e4198));
let _e4643 = global_3.member[bitcast<u32>(select(0i, _e4637, (_e4637 > 0i)))];
let _e4648 = (bitcast<f32>(((_e4600 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4656 = (_e4648 + (((bitcast<f32>(((_e4609 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4648) * _e4590));
let _e4661 = (bitcast<f32>(((_e4618 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4687 = (((_e4656 + (((_e4661 + (((bitcast<f32>(((_e4627 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4661) * _e4590)) - _e4656) * _e4588)) * _e4592) + (((bitcast<f32>(((_e4635 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4577) + ((bitcast<f32>(((_e4643 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4583)));
let _e4704 = (bitcast<f32>((((_e4600 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4712 = (_e4704 + (((bitcast<f32>((((_e4609 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4704) * _e4590));
let _e4717 = (bitcast<f32>((((_e4618 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4744 = (_e4586 + 1i);
let _e4746 = select(_e4198, _e4744, (_e4744 < _e4198));
let _e4752 = global_3.member[bitcast<u32>(select(0i, _e4746, (_e4746 > 0i)))];
let _e4753 = (_e4586 + 5i);
let _e4755 = select(_e4198, _e4753, (_e4753 < _e4198));
let _e4761 = global_3.member[bitcast<u32>(select(0i, _e4755, (_e4755 > 0i)))];
let _e4762 = (_e4586 + 1025i);
let _e4764 = select(_e4198, _e4762, (_e4762 < _e4198));
let _e4770 = global_3.member[bitcast<u32>(select(0i, _e4764, (_e4764 > 0i)))];
let _e4771 = (_e4586 + 1029i);
let _e4773 = select(_e4198, _e4771, (_e4771 < _e4198));
let _e4779 = global_3.member[bitcast<u32>(select(0i, _e4773, (_e4773 > 0i)))];
let _e4781 = select(_e4198, 1i, (1i < _e4198));
let _e4787 = global_3.member[bitcast<u32>(select(0i, _e4781, (_e4781 > 0i)))];
let _e4789 = select(_e4198, 262141i, (262141i < _e4198));
let _e4795 = global_3.member[bitcast<u32>(select(0i, _e4789, (_e4789 > 0i)))];
let _e4800 = (bitcast<f32>(((_e4752 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4808 = (_e4800 + (((bitcast<f32>(((_e4761 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4800) * _e4590));
let _e4813 = (bitcast<f32>(((_e4770 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4856 = (bitcast<f32>((((_e4752 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4864 = (_e4856 + (((bitcast<f32>((((_e4761 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4856) * _e4590));
let _e4869 = (bitcast<f32>((((_e4770 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4899 = (_e3640 * _e3525.member_1);
let _e4901 = -(((((_e4712 + (((_e4717 + (((bitcast<f32>((((_e4627 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4717) * _e4590)) - _e4712) * _e4588)) * _e4592) + (((bitcast<f32>((((_e4635 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4577) + ((bitcast<f32>((((_e4643 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4583))) * _e4899));
let _e4903 = select(-87f, _e4901, (_e4901 > -87f));
let _e4905 = select(88f, _e4903, (_e4903 < 88f));
let _e4907 = ((_e4905 * 1.442695f) + 0.5f);
let _e4909 = select(-127f, _e4907, (_e4907 > -127f));
let _e4911 = select(128f, _e4909, (_e4909 < 128f));
let _e4918 = select(0i, select(select(i32(_e4911), i32(-2147483648), (_e4911 < -2147483600f)), 2147483647i, (_e4911 > 2147483500f)), (_e4911 == _e4911));
let _e4922 = (_e4918 - select(0i, 1i, (_e4911 < f32(_e4918))));
let _e4923 = f32(_e4922);
let _e4927 = ((_e4905 - (_e4923 * 0.6933594f)) - (_e4923 * -2.1219444e-4f));
let _e4949 = -(((((_e4808 + (((_e4813 + (((bitcast<f32>(((_e4779 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4813) * _e4590)) - _e4808) * _e4588)) * _e4592) + (((bitcast<f32>(((_e4787 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4577) + ((bitcast<f32>(((_e4795 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4583))) * _e4899));
let _e4951 = select(-87f, _e4949, (_e4949 > -87f));
let _e4953 = select(88f, _e4951, (_e4951 < 88f));
let _e4955 = ((_e4953 * 1.442695f) + 0.5f);
let _e4957 = select(-127f, _e4955, (_e4955 > -127f));
let _e4959 = select(128f, _e4957, (_e4957 < 128f));
let _e4966 = select(0i, select(select(i32(_e4959), i32(-2147483648), (_e4959 < -2147483600f)), 2147483647i, (_e4959 > 2147483500f)), (_e4959 == _e4959));
let _e4970 = (_e4966 - select(0i, 1i, (_e4959 < f32(_e4966))));
let _e4971 = f32(_e4970);
let _e4975 = ((_e4953 - (_e4971 * 0.6933594f)) - (_e4971 * -2.1219444e-4f));
let _e4997 = -(((((_e4864 + (((_e4869 + (((bitcast<f32>((((_e4779 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4869) * _e4590)) - _e4864) * _e4588)) * _e4592) + (((bitcast<f32>((((_e4787 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4577) + ((bitcast<f32>((((_e4795 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4583))) * _e4899));
let _e4999 = select(-87f, _e4997, (_e4997 > -87f));
let _e5001 = select(88f, _e4999, (_e4999 < 88f));
let _e5003 = ((_e5001 * 1.442695f) + 0.5f);
let _e5005 = select(-127f, _e5003, (_e5003 > -127f));
let _e5007 = select(128f, _e5005, (_e5005 < 128f));
let _e5014 = select(0i, select(select(i32(_e5007), i32(-2147483648), (_e5007 < -2147483600f)), 2147483647i, (_e5007 > 2147483500f)), (_e5007 == _e5007));
let _e5018 = (_e5014 - select(0i, 1i, (_e5007 < f32(_e5014))));
let _e5019 = f32(_e5018);
let _e5023 = ((_e5001 - (_e5019 * 0.6933594f)) - (_e5019 * -2.1219444e-4f));
let _e5046 = -((_e4687 * (_e3640 * _e3525.member)));
let _e5048 = select(-87f, _e5046, (_e5046 > -87f));
let _e5050 = select(88f, _e5048, (_e5048 < 88f));
let _e5052 = ((_e5050 * 1.442695f) + 0.5f);
let _e5054 = select(-127f, _e5052, (_e5052 > -127f));
let _e5056 = select(128f, _e5054, (_e5054 < 128f));
let _e5063 = select(0i, select(select(i32(_e5056), i32(-2147483648), (_e5056 < -2147483600f)), 2147483647i, (_e5056 > 2147483500f)), (_e5056 == _e5056));
let _e5067 = (_e5063 - select(0i, 1i, (_e5056 < f32(_e5063))));
let _e5068 = f32(_e5067);
let _e5072 = ((_e5050 - (_e5068 * 0.6933594f)) - (_e5068 * -2.1219444e-4f));
let _e5092 = ((1f + (_e5072 * (1f + (_e5072 * (0.5f + (_e5072 * (0.16666667f + (_e5072 * (0.041666668f + (_e5072 * (0.008333334f + (_e5072 * (0.001388889f + (_e5072 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5067 + 127i)) << bitcast<u32>(23i))));
let _e5093 = (1f - _e5092);
phi_12128_ = type_35(_e5092, _e5093, vec3<f32>(((1f + (_e4927 * (1f + (_e4927 * (0.5f + (_e4927 * (0.16666667f + (_e4927 * (0.041666668f + (_e4927 * (0.008333334f + (_e4927 * (0.001388889f + (_e4927 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4922 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4975 * (1f + (_e4975 * (0.5f + (_e4975 * (0.16666667f + (_e4975 * (0.041666668f + (_e4975 * (0.008333334f + (_e4975 * (0.001388889f + (_e4975 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4970 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5023 * (1f + (_e5023 * (0.5f + (_e5023 * (0.16666667f + (_e5023 * (0.041666668f + (_e5023 * (0.008333334f + (_e5023 * (0.001388889f + (_e5023 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5018 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e5093 / select(1e-12f, _e4687, (_e4687 > 1e-12f))))));
}
let _e5101 = phi_12128_;
if _e1229 {
let _e5106 = global_1.member.member_8.member.member;
let _e5114 = global_1.member.member_8.member_1.member;
let _e5122 = global_1.member.member_8.member_2.member;
let _e5126 = (-0.5f - _e1208);
let _e5127 = -(_e3533);
let _e5130 = (_e3533 - _e5126);
let _e5131 = (_e5126 - _e3533);
let _e5133 = select(_e5131, _e5130, (_e5130 > _e5131));
let _e5136 = (select(_e5127, _e3533, (_e3533 > _e5127)) / select(1e-30f, _e5133, (_e5133 > 1e-30f)));
let _e5138 = (_e5126 < 0f);
let _e5140 = select(0f, select(2f, _e5136, _e5138), (_e3533 > 0f));
let _e5141 = (_e5126 > 0f);
let _e5144 = select(2f, select(0f, _e5136, (_e3533 < 0f)), _e5141);
let _e5145 = (_e3533 > -1e30f);
let _e5149 = ((_e5140 > -1f) || ((_e5140 == -1f) && _e5145));
let _e5150 = (_e5144 < 2f);
let _e5151 = select(-1f, _e5140, _e5149);
let _e5155 = select(2f, _e5144, _e5150);
let _e5159 = select(-1e30f, _e3533, _e5145);
let _e5160 = (_e5126 > -1e30f);
let _e5161 = select(-1e30f, _e5126, _e5160);
let _e5165 = (_e1172 - _e3046);
let _e5166 = (_e1208 - _e3046);
let _e5167 = -(_e5165);
let _e5170 = (_e5165 - _e5166);
let _e5171 = (_e5166 - _e5165);
let _e5173 = select(_e5171, _e5170, (_e5170 > _e5171));
let _e5176 = (select(_e5167, _e5165, (_e5165 > _e5167)) / select(1e-30f, _e5173, (_e5173 > 1e-30f)));
let _e5178 = (_e5166 < 0f);
let _e5180 = select(0f, select(2f, _e5176, _e5178), (_e5165 > 0f));
let _e5181 = (_e5166 > 0f);
let _e5184 = select(2f, select(0f, _e5176, (_e5165 < 0f)), _e5181);
let _e5185 = (_e5165 > _e5159);
let _e5189 = ((_e5180 > _e5151) || ((_e5180 == _e5151) && _e5185));
let _e5190 = (_e5184 < _e5155);
let _e5191 = select(_e5151, _e5180, _e5189);
let _e5195 = select(_e5155, _e5184, _e5190);
let _e5199 = select(_e5159, _e5165, _e5185);
let _e5200 = (_e5166 > _e5161);
let _e5201 = select(_e5161, _e5166, _e5200);
let _e5205 = (-0.5f - _e1214);
let _e5206 = -(_e3562);
let _e5209 = (_e3562 - _e5205);
let _e5210 = (_e5205 - _e3562);
let _e5212 = select(_e5210, _e5209, (_e5209 > _e5210));
let _e5215 = (select(_e5206, _e3562, (_e3562 > _e5206)) / select(1e-30f, _e5212, (_e5212 > 1e-30f)));
let _e5217 = (_e5205 < 0f);
let _e5219 = select(0f, select(2f, _e5215, _e5217), (_e3562 > 0f));
let _e5220 = (_e5205 > 0f);
let _e5223 = select(2f, select(0f, _e5215, (_e3562 < 0f)), _e5220);
let _e5224 = (_e3562 > _e5199);
let _e5228 = ((_e5219 > _e5191) || ((_e5219 == _e5191) && _e5224));
let _e5229 = (_e5223 < _e5195);
let _e5230 = select(_e5191, _e5219, _e5228);
let _e5234 = select(_e5195, _e5223, _e5229);
let _e5238 = select(_e5199, _e3562, _e5224);
let _e5239 = (_e5205 > _e5201);
let _e5240 = select(_e5201, _e5205, _e5239);
let _e5244 = (_e1187 - _e3056);
let _e5245 = (_e1214 - _e3056);
let _e5246 = -(_e5244);
let _e5249 = (_e5244 - _e5245);
let _e5250 = (_e5245 - _e5244);
let _e5252 = select(_e5250, _e5249, (_e5249 > _e5250));
let _e5255 = (select(_e5246, _e5244, (_e5244 > _e5246)) / select(1e-30f, _e5252, (_e5252 > 1e-30f)));
let _e5257 = (_e5245 < 0f);
let _e5259 = select(0f, select(2f, _e5255, _e5257), (_e5244 > 0f));
let _e5260 = (_e5245 > 0f);
let _e5263 = select(2f, select(0f, _e5255, (_e5244 < 0f)), _e5260);
let _e5264 = (_e5244 > _e5238);
let _e5268 = ((_e5259 > _e5230) || ((_e5259 == _e5230) && _e5264));
let _e5269 = (_e5263 < _e5234);
let _e5270 = select(_e5230, _e5259, _e5268);
let _e5274 = select(_e5234, _e5263, _e5269);
let _e5278 = select(_e5238, _e5244, _e5264);
let _e5279 = (_e5245 > _e5240);
let _e5280 = select(_e5240, _e5245, _e5279);
let _e5284 = (-0.5f - _e1220);
let _e5285 = -(_e3591);
let _e5288 = (_e3591 - _e5284);
let _e5289 = (_e5284 - _e3591);
let _e5291 = select(_e5289, _e5288, (_e5288 > _e5289));
let _e5294 = (select(_e5285, _e3591, (_e3591 > _e5285)) / select(1e-30f, _e5291, (_e5291 > 1e-30f)));
let _e5296 = (_e5284 < 0f);
let _e5298 = select(0f, select(2f, _e5294, _e5296), (_e3591 > 0f));
let _e5299 = (_e5284 > 0f);
let _e5302 = select(2f, select(0f, _e5294, (_e3591 < 0f)), _e5299);
let _e5303 = (_e3591 > _e5278);
let _e5307 = ((_e5298 > _e5270) || ((_e5298 == _e5270) && _e5303));
let _e5308 = (_e5302 < _e5274);
let _e5309 = select(_e5270, _e5298, _e5307);
let _e5313 = select(_e5274, _e5302, _e5308);
let _e5317 = select(_e5278, _e3591, _e5303);
let _e5318 = (_e5284 > _e5280);
let _e5319 = select(_e5280, _e5284, _e5318);
let _e5323 = (_e1202 - _e3066);
let _e5324 = (_e1220 - _e3066);
let _e5325 = -(_e5323);
let _e5328 = (_e5323 - _e5324);
let _e5329 = (_e5324 - _e5323);
let _e5331 = select(_e5329, _e5328, (_e5328 > _e5329));
let _e5334 = (select(_e5325, _e5323, (_e5323 > _e5325)) / select(1e-30f, _e5331, (_e5331 > 1e-30f)));
let _e5336 = (_e5324 < 0f);
let _e5338 = select(0f, select(2f, _e5334, _e5336), (_e5323 > 0f));
let _e5339 = (_e5324 > 0f);
let _e5342 = select(2f, select(0f, _e5334, (_e5323 < 0f)), _e5339);
let _e5343 = (_e5323 > _e5317);
let _e5347 = ((_e5338 > _e5309) || ((_e5338 == _e5309) && _e5343));
let _e5348 = (_e5342 < _e5313);
let _e5349 = select(_e5309, _e5338, _e5347);
let _e5350 = select(select(select(select(select(select(0f, _e5106.member, _e5149), _e5106.member, _e5189), _e5114.member, _e5228), _e5114.member, _e5268), _e5122.member, _e5307), _e5122.member, _e5347);
let _e5351 = select(select(select(select(select(select(0f, _e5106.member_1, _e5149), _e5106.member_1, _e5189), _e5114.member_1, _e5228), _e5114.member_1, _e5268), _e5122.member_1, _e5307), _e5122.member_1, _e5347);
let _e5352 = select(select(select(select(select(select(1f, _e5106.member_2, _e5149), _e5106.member_2, _e5189), _e5114.member_2, _e5228), _e5114.member_2, _e5268), _e5122.member_2, _e5307), _e5122.member_2, _e5347);
let _e5354 = select(_e5313, _e5342, _e5348);
let _e5355 = select(select(select(select(select(select(0f, _e5106.member, _e5150), _e5106.member, _e5190), _e5114.member, _e5229), _e5114.member, _e5269), _e5122.member, _e5308), _e5122.member, _e5348);
let _e5356 = select(select(select(select(select(select(0f, _e5106.member_1, _e5150), _e5106.member_1, _e5190), _e5114.member_1, _e5229), _e5114.member_1, _e5269), _e5122.member_1, _e5308), _e5122.member_1, _e5348);
let _e5357 = select(select(select(select(select(select(1f, _e5106.member_2, _e5150), _e5106.member_2, _e5190), _e5114.member_2, _e5229), _e5114.member_2, _e5269), _e5122.member_2, _e5308), _e5122.member_2, _e5348);
let _e5359 = select(_e5317, _e5323, _e5343);
let _e5360 = (_e5324 > _e5319);
let _e5361 = select(_e5319, _e5324, _e5360);
let _e5362 = select(select(select(select(select(select(0f, _e5106.member, _e5145), _e5106.member, _e5185), _e5114.member, _e5224), _e5114.member, _e5264), _e5122.member, _e5303), _e5122.member, _e5343);
let _e5363 = select(select(select(select(select(select(0f, _e5106.member_1, _e5145), _e5106.member_1, _e5185), _e5114.member_1, _e5224), _e5114.member_1, _e5264), _e5122.member_1, _e5303), _e5122.member_1, _e5343);
let _e5364 = select(select(select(select(select(select(1f, _e5106.member_2, _e5145), _e5106.member_2, _e5185), _e5114.member_2, _e5224), _e5114.member_2, _e5264), _e5122.member_2, _e5303), _e5122.member_2, _e5343);
if _e3322 {
phi_13447_ = type_34(_e5349, vec3<f32>(_e5350, _e5351, _e5352), _e5354, vec3<f32>(_e5355, _e5356, _e5357), _e5359, _e5361, vec3<f32>(_e5362, _e5363, _e5364));
} else {
let _e5371 = (((_e5106.member * _e5106.member) + (_e5106.member_1 * _e5106.member_1)) + (_e5106.member_2 * _e5106.member_2));
let _e5374 = sqrt(select(0f, _e5371, (_e5371 > 0f)));
let _e5378 = global_1.member.member_16.member_1;
let _e5379 = (_e5378 != 0u);
let _e5383 = global_1.member.member_16.member;
let _e5403 = select(-1e6f, (((((_e5383.member.member * _e1129) + (_e5383.member.member_1 * _e1142)) + (_e5383.member.member_2 * _e1107)) + _e5383.member_1) * _e5374), _e5379);
let _e5404 = select(-1e6f, (((((_e5383.member.member * _e1152) + (_e5383.member.member_1 * _e1157)) + (_e5383.member.member_2 * _e1146)) + _e5383.member_1) * _e5374), _e5379);
let _e5409 = global_1.member.member_16.member.member;
let _e5413 = -(_e5403);
let _e5416 = (_e5403 - _e5404);
let _e5417 = (_e5404 - _e5403);
let _e5419 = select(_e5417, _e5416, (_e5416 > _e5417));
let _e5422 = (select(_e5413, _e5403, (_e5403 > _e5413)) / select(1e-30f, _e5419, (_e5419 > 1e-30f)));
let _e5426 = select(0f, select(2f, _e5422, (_e5404 < 0f)), (_e5403 > 0f));
let _e5430 = select(2f, select(0f, _e5422, (_e5403 < 0f)), (_e5404 > 0f));
let _e5431 = (_e5403 > _e5359);
let _e5435 = ((_e5426 > _e5349) || ((_e5426 == _e5349) && _e5431));
let _e5436 = (_e5430 < _e5354);
let _e5437 = select(_e5349, _e5426, _e5435);
let _e5441 = select(_e5354, _e5430, _e5436);
let _e5445 = select(_e5359, _e5403, _e5431);
let _e5447 = select(_e5361, _e5404, (_e5404 > _e5361));
let _e5454 = global_1.member.member_17.member_1;
let _e5455 = (_e5454 != 0u);
let _e5459 = global_1.member.member_17.member;
let _e5479 = select(-1e6f, (((((_e5459.member.member * _e1129) + (_e5459.member.member_1 * _e1142)) + (_e5459.member.member_2 * _e1107)) + _e5459.member_1) * _e5374), _e5455);
let _e5480 = select(-1e6f, (((((_e5459.member.member * _e1152) + (_e5459.member.member_1 * _e1157)) + (_e5459.member.member_2 * _e1146)) + _e5459.member_1) * _e5374), _e5455);
let _e5485 = global_1.member.member_17.member.member;
let _e5489 = -(_e5479);
let _e5492 = (_e5479 - _e5480);
let _e5493 = (_e5480 - _e5479);
let _e5495 = select(_e5493, _e5492, (_e5492 > _e5493));
let _e5498 = (select(_e5489, _e5479, (_e5479 > _e5489)) / select(1e-30f, _e5495, (_e5495 > 1e-30f)));
let _e5502 = select(0f, select(2f, _e5498, (_e5480 < 0f)), (_e5479 > 0f));
let _e5506 = select(2f, select(0f, _e5498, (_e5479 < 0f)), (_e5480 > 0f));
let _e5507 = (_e5479 > _e5445);
let _e5511 = ((_e5502 > _e5437) || ((_e5502 == _e5437) && _e5507));
let _e5512 = (_e5506 < _e5441);
let _e5513 = select(_e5437, _e5502, _e5511);
let _e5517 = select(_e5441, _e5506, _e5512);
let _e5521 = select(_e5445, _e5479, _e5507);
let _e5523 = select(_e5447, _e5480, (_e5480 > _e5447));
let _e5530 = global_1.member.member_18.member_1;
let _e5531 = (_e5530 != 0u);
let _e5535 = global_1.member.member_18.member;
let _e5555 = select(-1e6f, (((((_e5535.member.member * _e1129) + (_e5535.member.member_1 * _e1142)) + (_e5535.member.member_2 * _e1107)) + _e5535.member_1) * _e5374), _e5531);
let _e5556 = select(-1e6f, (((((_e5535.member.member * _e1152) + (_e5535.member.member_1 * _e1157)) + (_e5535.member.member_2 * _e1146)) + _e5535.member_1) * _e5374), _e5531);
let _e5561 = global_1.member.member_18.member.member;
let _e5565 = -(_e5555);
let _e5568 = (_e5555 - _e5556);
let _e5569 = (_e5556 - _e5555);
let _e5571 = select(_e5569, _e5568, (_e5568 > _e5569));
let _e5574 = (select(_e5565, _e5555, (_e5555 > _e5565)) / select(1e-30f, _e5571, (_e5571 > 1e-30f)));
let _e5578 = select(0f, select(2f, _e5574, (_e5556 < 0f)), (_e5555 > 0f));
let _e5582 = select(2f, select(0f, _e5574, (_e5555 < 0f)), (_e5556 > 0f));
let _e5583 = (_e5555 > _e5521);
let _e5587 = ((_e5578 > _e5513) || ((_e5578 == _e5513) && _e5583));
let _e5588 = (_e5582 < _e5517);
let _e5589 = select(_e5513, _e5578, _e5587);
let _e5593 = select(_e5517, _e5582, _e5588);
let _e5597 = select(_e5521, _e5555, _e5583);
let _e5599 = select(_e5523, _e5556, (_e5556 > _e5523));
let _e5606 = global_1.member.member_19.member_1;
let _e5607 = (_e5606 != 0u);
let _e5611 = global_1.member.member_19.member;
let _e5631 = select(-1e6f, (((((_e5611.member.member * _e1129) + (_e5611.member.member_1 * _e1142)) + (_e5611.member.member_2 * _e1107)) + _e5611.member_1) * _e5374), _e5607);
let _e5632 = select(-1e6f, (((((_e5611.member.member * _e1152) + (_e5611.member.member_1 * _e1157)) + (_e5611.member.member_2 * _e1146)) + _e5611.member_1) * _e5374), _e5607);
let _e5637 = global_1.member.member_19.member.member;
let _e5641 = -(_e5631);
let _e5644 = (_e5631 - _e5632);
let _e5645 = (_e5632 - _e5631);
let _e5647 = select(_e5645, _e5644, (_e5644 > _e5645));
let _e5650 = (select(_e5641, _e5631, (_e5631 > _e5641)) / select(1e-30f, _e5647, (_e5647 > 1e-30f)));
let _e5654 = select(0f, select(2f, _e5650, (_e5632 < 0f)), (_e5631 > 0f));
let _e5658 = select(2f, select(0f, _e5650, (_e5631 < 0f)), (_e5632 > 0f));
let _e5659 = (_e5631 > _e5597);
let _e5663 = ((_e5654 > _e5589) || ((_e5654 == _e5589) && _e5659));
let _e5664 = (_e5658 < _e5593);
phi_13447_ = type_34(select(_e5589, _e5654, _e5663), vec3<f32>(select(select(select(select(_e5350, _e5409.member, _e5435), _e5485.member, _e5511), _e5561.member, _e5587), _e5637.member, _e5663), select(select(select(select(_e5351, _e5409.member_1, _e5435), _e5485.member_1, _e5511), _e5561.member_1, _e5587), _e5637.member_1, _e5663), select(select(select(select(_e5352, _e5409.member_2, _e5435), _e5485.member_2, _e5511), _e5561.member_2, _e5587), _e5637.member_2, _e5663)), select(_e5593, _e5658, _e5664), vec3<f32>(select(select(select(select(_e5355, _e5409.member, _e5436), _e5485.member, _e5512), _e5561.member, _e5588), _e5637.member, _e5664), select(select(select(select(_e5356, _e5409.member_1, _e5436), _e5485.member_1, _e5512), _e5561.member_1, _e5588), _e5637.member_1, _e5664), select(select(select(select(_e5357, _e5409.member_2, _e5436), _e5485.member_2, _e5512), _e5561.member_2, _e5588), _e5637.member_2, _e5664)), select(_e5597, _e5631, _e5659), select(_e5599, _e5632, (_e5632 > _e5599)), vec3<f32>(select(select(select(select(_e5362, _e5409.member, _e5431), _e5485.member, _e5507), _e5561.member, _e5583), _e5637.member, _e5659), select(select(select(select(_e5363, _e5409.member_1, _e5431), _e5485.member_1, _e5507), _e5561.member_1, _e5583), _e5637.member_1, _e5659), select(select(select(select(_e5364, _e5409.member_2, _e5431), _e5485.member_2, _e5507), _e5561.member_2, _e5583), _e5637.member_2, _e5659)));
}
let _e5684 = phi_13447_;
let _e5686 = (_e5684.member_4 < 0f);
let _e5688 = (_e5684.member_5 < 0f);
let _e5689 = (_e5686 != _e5688);
if _e5686 {
phi_13460_ = _e5684.member_3;
phi_13461_ = _e5684.member_2;
} else {
phi_13460_ = _e5684.member_1;
phi_13461_ = _e5684.member;
}
let _e5695 = phi_13460_;
let _e5697 = phi_13461_;
let _e5706 = (((_e5106.member * _e5106.member) + (_e5106.member_1 * _e5106.member_1)) + (_e5106.member_2 * _e5106.member_2));
let _e5709 = sqrt(select(0f, _e5706, (_e5706 > 0f)));
let _e5710 = ((1.5f * _e1127) * _e5709);
let _e5715 = select(0f, _e5697, _e5689);
let _e5719 = (_e1129 + (_e3624 * _e5715));
let _e5720 = (_e1142 + (_e3625 * _e5715));
let _e5721 = (_e1107 + (_e3626 * _e5715));
let _e5727 = ((((_e1161.member.member * _e5719) + (_e1161.member.member_1 * _e5720)) + (_e1161.member.member_2 * _e5721)) + _e1161.member_1);
let _e5733 = ((((_e1176.member.member * _e5719) + (_e1176.member.member_1 * _e5720)) + (_e1176.member.member_2 * _e5721)) + _e1176.member_1);
let _e5739 = ((((_e1191.member.member * _e5719) + (_e1191.member.member_1 * _e5720)) + (_e1191.member.member_2 * _e5721)) + _e1191.member_1);
let _e5741 = select(-0.5f, _e5727, (_e5727 > -0.5f));
let _e5743 = select(_e3046, _e5741, (_e5741 < _e3046));
let _e5745 = select(-0.5f, _e5733, (_e5733 > -0.5f));
let _e5747 = select(_e3056, _e5745, (_e5745 < _e3056));
let _e5749 = select(-0.5f, _e5739, (_e5739 > -0.5f));
let _e5751 = select(_e3066, _e5749, (_e5749 < _e3066));
let _e5753 = select(-1f, _e5743, (_e5743 > -1f));
let _e5755 = select(_e3045, _e5753, (_e5753 < _e3045));
let _e5762 = select(0i, select(select(i32(_e5755), i32(-2147483648), (_e5755 < -2147483600f)), 2147483647i, (_e5755 > 2147483500f)), (_e5755 == _e5755));
let _e5766 = (_e5762 - select(0i, 1i, (_e5755 < f32(_e5762))));
let _e5768 = select(-1f, _e5747, (_e5747 > -1f));
let _e5770 = select(_e3055, _e5768, (_e5768 < _e3055));
let _e5777 = select(0i, select(select(i32(_e5770), i32(-2147483648), (_e5770 < -2147483600f)), 2147483647i, (_e5770 > 2147483500f)), (_e5770 == _e5770));
let _e5781 = (_e5777 - select(0i, 1i, (_e5770 < f32(_e5777))));
let _e5783 = select(-1f, _e5751, (_e5751 > -1f));
let _e5785 = select(_e3065, _e5783, (_e5783 < _e3065));
let _e5792 = select(0i, select(select(i32(_e5785), i32(-2147483648), (_e5785 < -2147483600f)), 2147483647i, (_e5785 > 2147483500f)), (_e5785 == _e5785));
let _e5796 = (_e5792 - select(0i, 1i, (_e5785 < f32(_e5792))));
let _e5797 = (_e5766 + 1i);
let _e5798 = (_e5781 + 1i);
let _e5799 = (_e5796 + 1i);
let _e5809 = ((_e5797 >> bitcast<u32>(4i)) + (_e3132 * ((_e5798 >> bitcast<u32>(4i)) + (_e3138 * (_e5799 >> bitcast<u32>(4i))))));
let _e5811 = select(_e3150, _e5809, (_e5809 < _e3150));
let _e5817 = global_2.member[bitcast<u32>(select(0i, _e5811, (_e5811 > 0i)))];
let _e5819 = (_e5797 & 15i);
let _e5822 = ((_e5798 & 15i) * _e3119);
let _e5824 = (bitcast<i32>(_e5817) + ((_e5799 & 15i) * _e3123));
let _e5828 = (_e5822 + _e3119);
let _e5829 = (_e5822 + _e3170);
let _e5830 = (_e5824 + _e3123);
let _e5831 = (_e5824 + _e3173);
local_2 = type_29(array<i32, 4>(_e5819, (_e5819 + 1i), (_e5819 + 2i), (_e5819 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e5743 - f32(_e5766)), (_e5747 - f32(_e5781)), (_e5751 - f32(_e5796)));
let _e5842 = (_e5830 + _e5828);
let _e5845 = local_2.member[1u];
let _e5846 = (_e5842 + _e5845);
let _e5848 = select(_e3150, _e5846, (_e5846 < _e3150));
let _e5853 = global_2.member[bitcast<u32>(select(0i, _e5848, (_e5848 > 0i)))];
let _e5854 = bitcast<f32>(_e5853);
let _e5857 = local_2.member[2u];
let _e5858 = (_e5842 + _e5857);
let _e5860 = select(_e3150, _e5858, (_e5858 < _e3150));
let _e5865 = global_2.member[bitcast<u32>(select(0i, _e5860, (_e5860 > 0i)))];
let _e5867 = local_3[0u];
let _e5870 = (_e5854 + ((bitcast<f32>(_e5865) - _e5854) * _e5867));
let _e5871 = (_e5830 + _e5829);
let _e5872 = local_2.member[1u];
let _e5873 = (_e5871 + _e5872);
let _e5875 = select(_e3150, _e5873, (_e5873 < _e3150));
let _e5880 = global_2.member[bitcast<u32>(select(0i, _e5875, (_e5875 > 0i)))];
let _e5881 = bitcast<f32>(_e5880);
let _e5882 = local_2.member[2u];
let _e5883 = (_e5871 + _e5882);
let _e5885 = select(_e3150, _e5883, (_e5883 < _e3150));
let _e5890 = global_2.member[bitcast<u32>(select(0i, _e5885, (_e5885 > 0i)))];
let _e5892 = local_3[0u];
let _e5897 = local_3[1u];
let _e5900 = (_e5870 + (((_e5881 + ((bitcast<f32>(_e5890) - _e5881) * _e5892)) - _e5870) * _e5897));
let _e5901 = (_e5831 + _e5828);
let _e5902 = local_2.member[1u];
let _e5903 = (_e5901 + _e5902);
let _e5905 = select(_e3150, _e5903, (_e5903 < _e3150));
let _e5910 = global_2.member[bitcast<u32>(select(0i, _e5905, (_e5905 > 0i)))];
let _e5911 = bitcast<f32>(_e5910);
let _e5912 = local_2.member[2u];
let _e5913 = (_e5901 + _e5912);
let _e5915 = select(_e3150, _e5913, (_e5913 < _e3150));
let _e5920 = global_2.member[bitcast<u32>(select(0i, _e5915, (_e5915 > 0i)))];
let _e5922 = local_3[0u];
let _e5925 = (_e5911 + ((bitcast<f32>(_e5920) - _e5911) * _e5922));
let _e5926 = (_e5831 + _e5829);
let _e5927 = local_2.member[1u];
let _e5928 = (_e5926 + _e5927);
let _e5930 = select(_e3150, _e5928, (_e5928 < _e3150));
let _e5935 = global_2.member[bitcast<u32>(select(0i, _e5930, (_e5930 > 0i)))];
let _e5936 = bitcast<f32>(_e5935);
let _e5937 = local_2.member[2u];
let _e5938 = (_e5926 + _e5937);
let _e5940 = select(_e3150, _e5938, (_e5938 < _e3150));
let _e5945 = global_2.member[bitcast<u32>(select(0i, _e5940, (_e5940 > 0i)))];
let _e5947 = local_3[0u];
let _e5951 = local_3[1u];
let _e5956 = local_3[2u];
let _e5961 = (((_e5900 + (((_e5925 + (((_e5936 + ((bitcast<f32>(_e5945) - _e5936) * _e5947)) - _e5925) * _e5951)) - _e5900) * _e5956)) - _e3306) * _e3310);
let _e5963 = select(_e3313, _e5961, (_e5961 > _e3313));
local = select(1e9f, _e5963, (_e5963 < 1e9f));
let _e5966 = local;
local_1 = _e5966;
let _e5967 = local_1;
let _e5969 = (bitcast<i32>(_e165) - 1i);
let _e5971 = select(_e5969, 263197i, (263197i < _e5969));
let _e5976 = global_3.member[bitcast<u32>(select(0i, _e5971, (_e5971 > 0i)))];
let _e5979 = select(_e5969, 263198i, (263198i < _e5969));
let _e5984 = global_3.member[bitcast<u32>(select(0i, _e5979, (_e5979 > 0i)))];
let _e5987 = select(_e5969, 263199i, (263199i < _e5969));
let _e5992 = global_3.member[bitcast<u32>(select(0i, _e5987, (_e5987 > 0i)))];
let _e5993 = bitcast<f32>(_e5992);
let _e5995 = ((_e5967 - bitcast<f32>(_e5976)) * bitcast<f32>(_e5984));
let _e5997 = select(0f, _e5995, (_e5995 > 0f));
let _e6000 = local_1;
let _e6002 = select(_e5969, 263200i, (263200i < _e5969));
let _e6007 = global_3.member[bitcast<u32>(select(0i, _e6002, (_e6002 > 0i)))];
let _e6010 = select(_e5969, 263201i, (263201i < _e5969));
let _e6015 = global_3.member[bitcast<u32>(select(0i, _e6010, (_e6010 > 0i)))];
let _e6018 = select(_e5969, 263202i, (263202i < _e5969));
let _e6023 = global_3.member[bitcast<u32>(select(0i, _e6018, (_e6018 > 0i)))];
let _e6024 = bitcast<f32>(_e6023);
let _e6026 = ((_e6000 - bitcast<f32>(_e6007)) * bitcast<f32>(_e6015));
let _e6028 = select(0f, _e6026, (_e6026 > 0f));
let _e6032 = local_1;
let _e6034 = select(_e5969, 263203i, (263203i < _e5969));
let _e6039 = global_3.member[bitcast<u32>(select(0i, _e6034, (_e6034 > 0i)))];
let _e6042 = select(_e5969, 263204i, (263204i < _e5969));
let _e6047 = global_3.member[bitcast<u32>(select(0i, _e6042, (_e6042 > 0i)))];
let _e6050 = select(_e5969, 263205i, (263205i < _e5969));
let _e6055 = global_3.member[bitcast<u32>(select(0i, _e6050, (_e6050 > 0i)))];
let _e6056 = bitcast<f32>(_e6055);
let _e6058 = ((_e6032 - bitcast<f32>(_e6039)) * bitcast<f32>(_e6047));
let _e6060 = select(0f, _e6058, (_e6058 > 0f));
let _e6063 = local_1;
let _e6065 = select(_e5969, 263206i, (263206i < _e5969));
let _e6070 = global_3.member[bitcast<u32>(select(0i, _e6065, (_e6065 > 0i)))];
let _e6073 = select(_e5969, 263207i, (263207i < _e5969));
let _e6078 = global_3.member[bitcast<u32>(select(0i, _e6073, (_e6073 > 0i)))];
let _e6081 = select(_e5969, 263208i, (263208i < _e5969));
let _e6086 = global_3.member[bitcast<u32>(select(0i, _e6081, (_e6081 > 0i)))];
let _e6087 = bitcast<f32>(_e6086);
let _e6089 = ((_e6063 - bitcast<f32>(_e6070)) * bitcast<f32>(_e6078));
let _e6091 = select(0f, _e6089, (_e6089 > 0f));
let _e6095 = ((select(_e5993, _e5997, (_e5997 < _e5993)) + select(_e6024, _e6028, (_e6028 < _e6024))) + (select(_e6056, _e6060, (_e6060 < _e6056)) + select(_e6087, _e6091, (_e6091 < _e6087))));
let _e6097 = select(0f, _e6095, (_e6095 > 0f));
let _e6099 = select(1023f, _e6097, (_e6097 < 1023f));
let _e6106 = select(0i, select(select(i32(_e6099), i32(-2147483648), (_e6099 < -2147483600f)), 2147483647i, (_e6099 > 2147483500f)), (_e6099 == _e6099));
let _e6110 = (_e6106 - select(0i, 1i, (_e6099 < f32(_e6106))));
let _e6111 = (262147i + _e6110);
let _e6113 = select(_e5969, _e6111, (_e6111 < _e5969));
let _e6119 = global_3.member[bitcast<u32>(select(0i, _e6113, (_e6113 > 0i)))];
let _e6129 = select(_e5969, 262146i, (262146i < _e5969));
let _e6135 = global_3.member[bitcast<u32>(select(0i, _e6129, (_e6129 > 0i)))];
let _e6139 = select(_e5969, 262144i, (262144i < _e5969));
let _e6145 = global_3.member[bitcast<u32>(select(0i, _e6139, (_e6139 > 0i)))];
let _e6148 = select(_e5969, 262145i, (262145i < _e5969));
let _e6154 = global_3.member[bitcast<u32>(select(0i, _e6148, (_e6148 > 0i)))];
let _e6161 = ((bitcast<f32>(_e6145) + (f32(bitcast<i32>((_e6119 >> bitcast<u32>(12u)))) * bitcast<f32>(_e6154))) + ((f32((bitcast<i32>((_e6119 & 4095u)) - 2048i)) * bitcast<f32>(_e6135)) * (_e6095 - f32(_e6110))));
let _e6165 = select(_e5684.member_6.x, _e5695.x, _e5689);
let _e6168 = select(_e5684.member_6.y, _e5695.y, _e5689);
let _e6171 = select(_e5684.member_6.z, _e5695.z, _e5689);
let _e6172 = select(1f, _e6161, _e5688);
let _e6177 = (((_e6165 * _e6165) + (_e6168 * _e6168)) + (_e6171 * _e6171));
let _e6180 = sqrt(select(0f, _e6177, (_e6177 > 0f)));
let _e6183 = (1f / select(1e-20f, _e6180, (_e6180 > 1e-20f)));
let _e6184 = (_e6165 * _e6183);
let _e6185 = (_e6168 * _e6183);
let _e6186 = (_e6171 * _e6183);
let _e6191 = (((_e233 * _e6184) + (_e244 * _e6185)) + (_e255 * _e6186));
let _e6196 = (((_e233 * _e233) + (_e244 * _e244)) + (_e255 * _e255));
let _e6198 = ((_e6172 * _e6172) - _e6196);
let _e6199 = (_e6191 * _e6191);
let _e6200 = (_e6199 + _e6198);
let _e6203 = sqrt(select(0f, _e6200, (_e6200 > 0f)));
let _e6207 = (_e6200 <= 0f);
let _e6210 = select((select(_e6203, -(_e6203), (_e6191 < 0f)) - _e6191), (-2f * _e6191), _e6207);
let _e6211 = (_e6198 == 0f);
let _e6222 = (_e6207 && (_e6198 != 0f));
let _e6228 = (!(_e5689) && (_e6222 || (_e6199 < ((0.1f * 0.1f) * _e6196))));
let _e6230 = select(1e-12f, _e6196, (_e6196 > 1e-12f));
let _e6234 = (_e6172 / sqrt(select(0f, _e6230, (_e6230 > 0f))));
let _e6246 = ((_e5689 || (bitcast<f32>((bitcast<u32>(_e5684.member_4) & 2147483647u)) < select(1f, _e5710, (_e5710 < 1f)))) && (_e6161 != 1f));
let _e6247 = select(_e233, select(select(select((_e233 + (_e6184 * _e6210)), _e233, _e6211), _e233, _e6222), (_e233 * _e6234), _e6228), _e6246);
let _e6248 = select(_e244, select(select(select((_e244 + (_e6185 * _e6210)), _e244, _e6211), _e244, _e6222), (_e244 * _e6234), _e6228), _e6246);
let _e6249 = select(_e255, select(select(select((_e255 + (_e6186 * _e6210)), _e255, _e6211), _e255, _e6222), (_e255 * _e6234), _e6228), _e6246);
let _e6261 = global_1.member.member_7.member_2;
let _e6264 = (_e6261 / select(1e-6f, _e6249, (_e6249 > 1e-6f)));
let _e6268 = (_e1152 + (_e6247 * _e6264));
let _e6269 = (_e1157 + (_e6248 * _e6264));
let _e6270 = (_e1146 + (_e6249 * _e6264));
let _e6276 = ((((_e1161.member.member * _e6268) + (_e1161.member.member_1 * _e6269)) + (_e1161.member.member_2 * _e6270)) + _e1161.member_1);
let _e6282 = ((((_e1176.member.member * _e6268) + (_e1176.member.member_1 * _e6269)) + (_e1176.member.member_2 * _e6270)) + _e1176.member_1);
let _e6288 = ((((_e1191.member.member * _e6268) + (_e1191.member.member_1 * _e6269)) + (_e1191.member.member_2 * _e6270)) + _e1191.member_1);
let _e6289 = (-0.5f - _e6276);
let _e6290 = -(_e5126);
let _e6293 = (_e5126 - _e6289);
let _e6294 = (_e6289 - _e5126);
let _e6296 = select(_e6294, _e6293, (_e6293 > _e6294));
let _e6299 = (select(_e6290, _e5126, (_e5126 > _e6290)) / select(1e-30f, _e6296, (_e6296 > 1e-30f)));
let _e6302 = select(0f, select(2f, _e6299, (_e6289 < 0f)), _e5141);
let _e6305 = select(2f, select(0f, _e6299, _e5138), (_e6289 > 0f));
let _e6309 = ((_e6302 > -1f) || ((_e6302 == -1f) && _e5160));
let _e6310 = (_e6305 < 2f);
let _e6311 = select(-1f, _e6302, _e6309);
let _e6315 = select(2f, _e6305, _e6310);
let _e6320 = select(-1e30f, _e6289, (_e6289 > -1e30f));
let _e6324 = (_e6276 - _e3046);
let _e6325 = -(_e5166);
let _e6328 = (_e5166 - _e6324);
let _e6329 = (_e6324 - _e5166);
let _e6331 = select(_e6329, _e6328, (_e6328 > _e6329));
let _e6334 = (select(_e6325, _e5166, (_e5166 > _e6325)) / select(1e-30f, _e6331, (_e6331 > 1e-30f)));
let _e6337 = select(0f, select(2f, _e6334, (_e6324 < 0f)), _e5181);
let _e6340 = select(2f, select(0f, _e6334, _e5178), (_e6324 > 0f));
let _e6344 = ((_e6337 > _e6311) || ((_e6337 == _e6311) && _e5200));
let _e6345 = (_e6340 < _e6315);
let _e6346 = select(_e6311, _e6337, _e6344);
let _e6350 = select(_e6315, _e6340, _e6345);
let _e6355 = select(_e6320, _e6324, (_e6324 > _e6320));
let _e6359 = (-0.5f - _e6282);
let _e6360 = -(_e5205);
let _e6363 = (_e5205 - _e6359);
let _e6364 = (_e6359 - _e5205);
let _e6366 = select(_e6364, _e6363, (_e6363 > _e6364));
let _e6369 = (select(_e6360, _e5205, (_e5205 > _e6360)) / select(1e-30f, _e6366, (_e6366 > 1e-30f)));
let _e6372 = select(0f, select(2f, _e6369, (_e6359 < 0f)), _e5220);
let _e6375 = select(2f, select(0f, _e6369, _e5217), (_e6359 > 0f));
let _e6379 = ((_e6372 > _e6346) || ((_e6372 == _e6346) && _e5239));
let _e6380 = (_e6375 < _e6350);
let _e6381 = select(_e6346, _e6372, _e6379);
let _e6385 = select(_e6350, _e6375, _e6380);
let _e6390 = select(_e6355, _e6359, (_e6359 > _e6355));
let _e6394 = (_e6282 - _e3056);
let _e6395 = -(_e5245);
let _e6398 = (_e5245 - _e6394);
let _e6399 = (_e6394 - _e5245);
let _e6401 = select(_e6399, _e6398, (_e6398 > _e6399));
let _e6404 = (select(_e6395, _e5245, (_e5245 > _e6395)) / select(1e-30f, _e6401, (_e6401 > 1e-30f)));
let _e6407 = select(0f, select(2f, _e6404, (_e6394 < 0f)), _e5260);
let _e6410 = select(2f, select(0f, _e6404, _e5257), (_e6394 > 0f));
let _e6414 = ((_e6407 > _e6381) || ((_e6407 == _e6381) && _e5279));
let _e6415 = (_e6410 < _e6385);
let _e6416 = select(_e6381, _e6407, _e6414);
let _e6420 = select(_e6385, _e6410, _e6415);
let _e6425 = select(_e6390, _e6394, (_e6394 > _e6390));
let _e6429 = (-0.5f - _e6288);
let _e6430 = -(_e5284);
let _e6433 = (_e5284 - _e6429);
let _e6434 = (_e6429 - _e5284);
let _e6436 = select(_e6434, _e6433, (_e6433 > _e6434));
let _e6439 = (select(_e6430, _e5284, (_e5284 > _e6430)) / select(1e-30f, _e6436, (_e6436 > 1e-30f)));
let _e6442 = select(0f, select(2f, _e6439, (_e6429 < 0f)), _e5299);
let _e6445 = select(2f, select(0f, _e6439, _e5296), (_e6429 > 0f));
let _e6449 = ((_e6442 > _e6416) || ((_e6442 == _e6416) && _e5318));
let _e6450 = (_e6445 < _e6420);
let _e6451 = select(_e6416, _e6442, _e6449);
let _e6455 = select(_e6420, _e6445, _e6450);
let _e6460 = select(_e6425, _e6429, (_e6429 > _e6425));
let _e6464 = (_e6288 - _e3066);
let _e6465 = -(_e5324);
let _e6468 = (_e5324 - _e6464);
let _e6469 = (_e6464 - _e5324);
let _e6471 = select(_e6469, _e6468, (_e6468 > _e6469));
let _e6474 = (select(_e6465, _e5324, (_e5324 > _e6465)) / select(1e-30f, _e6471, (_e6471 > 1e-30f)));
let _e6477 = select(0f, select(2f, _e6474, (_e6464 < 0f)), _e5339);
let _e6480 = select(2f, select(0f, _e6474, _e5336), (_e6464 > 0f));
let _e6484 = ((_e6477 > _e6451) || ((_e6477 == _e6451) && _e5360));
let _e6485 = (_e6480 < _e6455);
let _e6486 = select(_e6451, _e6477, _e6484);
let _e6487 = select(select(select(select(select(select(0f, _e5106.member, _e6309), _e5106.member, _e6344), _e5114.member, _e6379), _e5114.member, _e6414), _e5122.member, _e6449), _e5122.member, _e6484);
let _e6488 = select(select(select(select(select(select(0f, _e5106.member_1, _e6309), _e5106.member_1, _e6344), _e5114.member_1, _e6379), _e5114.member_1, _e6414), _e5122.member_1, _e6449), _e5122.member_1, _e6484);
let _e6489 = select(select(select(select(select(select(1f, _e5106.member_2, _e6309), _e5106.member_2, _e6344), _e5114.member_2, _e6379), _e5114.member_2, _e6414), _e5122.member_2, _e6449), _e5122.member_2, _e6484);
let _e6491 = select(_e6455, _e6480, _e6485);
let _e6492 = select(select(select(select(select(select(0f, _e5106.member, _e6310), _e5106.member, _e6345), _e5114.member, _e6380), _e5114.member, _e6415), _e5122.member, _e6450), _e5122.member, _e6485);
let _e6493 = select(select(select(select(select(select(0f, _e5106.member_1, _e6310), _e5106.member_1, _e6345), _e5114.member_1, _e6380), _e5114.member_1, _e6415), _e5122.member_1, _e6450), _e5122.member_1, _e6485);
let _e6494 = select(select(select(select(select(select(1f, _e5106.member_2, _e6310), _e5106.member_2, _e6345), _e5114.member_2, _e6380), _e5114.member_2, _e6415), _e5122.member_2, _e6450), _e5122.member_2, _e6485);
let _e6497 = select(_e6460, _e6464, (_e6464 > _e6460));
let _e6498 = select(select(select(select(select(select(0f, _e5106.member, _e5160), _e5106.member, _e5200), _e5114.member, _e5239), _e5114.member, _e5279), _e5122.member, _e5318), _e5122.member, _e5360);
let _e6499 = select(select(select(select(select(select(0f, _e5106.member_1, _e5160), _e5106.member_1, _e5200), _e5114.member_1, _e5239), _e5114.member_1, _e5279), _e5122.member_1, _e5318), _e5122.member_1, _e5360);
let _e6500 = select(select(select(select(select(select(1f, _e5106.member_2, _e5160), _e5106.member_2, _e5200), _e5114.member_2, _e5239), _e5114.member_2, _e5279), _e5122.member_2, _e5318), _e5122.member_2, _e5360);
if _e3322 {
phi_16040_ = type_34(_e6486, vec3<f32>(_e6487, _e6488, _e6489), _e6491, vec3<f32>(_e6492, _e6493, _e6494), _e5361, _e6497, vec3<f32>(_e6498, _e6499, _e6500));
} else {
let _e6506 = global_1.member.member_16.member_1;
let _e6507 = (_e6506 != 0u);
let _e6511 = global_1.member.member_16.member;
let _e6531 = select(-1e6f, (((((_e6511.member.member * _e1152) + (_e6511.member.member_1 * _e1157)) + (_e6511.member.member_2 * _e1146)) + _e6511.member_1) * _e5709), _e6507);
let _e6532 = select(-1e6f, (((((_e6511.member.member * _e6268) + (_e6511.member.member_1 * _e6269)) + (_e6511.member.member_2 * _e6270)) + _e6511.member_1) * _e5709), _e6507);
let _e6537 = global_1.member.member_16.member.member;
let _e6541 = -(_e6531);
let _e6544 = (_e6531 - _e6532);
let _e6545 = (_e6532 - _e6531);
let _e6547 = select(_e6545, _e6544, (_e6544 > _e6545));
let _e6550 = (select(_e6541, _e6531, (_e6531 > _e6541)) / select(1e-30f, _e6547, (_e6547 > 1e-30f)));
let _e6554 = select(0f, select(2f, _e6550, (_e6532 < 0f)), (_e6531 > 0f));
let _e6558 = select(2f, select(0f, _e6550, (_e6531 < 0f)), (_e6532 > 0f));
let _e6559 = (_e6531 > _e5361);
let _e6563 = ((_e6554 > _e6486) || ((_e6554 == _e6486) && _e6559));
let _e6564 = (_e6558 < _e6491);
let _e6565 = select(_e6486, _e6554, _e6563);
let _e6569 = select(_e6491, _e6558, _e6564);
let _e6573 = select(_e5361, _e6531, _e6559);
let _e6575 = select(_e6497, _e6532, (_e6532 > _e6497));
let _e6582 = global_1.member.member_17.member_1;
let _e6583 = (_e6582 != 0u);
let _e6587 = global_1.member.member_17.member;
let _e6607 = select(-1e6f, (((((_e6587.member.member * _e1152) + (_e6587.member.member_1 * _e1157)) + (_e6587.member.member_2 * _e1146)) + _e6587.member_1) * _e5709), _e6583);
let _e6608 = select(-1e6f, (((((_e6587.member.member * _e6268) + (_e6587.member.member_1 * _e6269)) + (_e6587.member.member_2 * _e6270)) + _e6587.member_1) * _e5709), _e6583);
let _e6613 = global_1.member.member_17.member.member;
let _e6617 = -(_e6607);
let _e6620 = (_e6607 - _e6608);
let _e6621 = (_e6608 - _e6607);
let _e6623 = select(_e6621, _e6620, (_e6620 > _e6621));
let _e6626 = (select(_e6617, _e6607, (_e6607 > _e6617)) / select(1e-30f, _e6623, (_e6623 > 1e-30f)));
let _e6630 = select(0f, select(2f, _e6626, (_e6608 < 0f)), (_e6607 > 0f));
let _e6634 = select(2f, select(0f, _e6626, (_e6607 < 0f)), (_e6608 > 0f));
let _e6635 = (_e6607 > _e6573);
let _e6639 = ((_e6630 > _e6565) || ((_e6630 == _e6565) && _e6635));
let _e6640 = (_e6634 < _e6569);
let _e6641 = select(_e6565, _e6630, _e6639);
let _e6645 = select(_e6569, _e6634, _e6640);
let _e6649 = select(_e6573, _e6607, _e6635);
let _e6651 = select(_e6575, _e6608, (_e6608 > _e6575));
let _e6658 = global_1.member.member_18.member_1;
let _e6659 = (_e6658 != 0u);
let _e6663 = global_1.member.member_18.member;
let _e6683 = select(-1e6f, (((((_e6663.member.member * _e1152) + (_e6663.member.member_1 * _e1157)) + (_e6663.member.member_2 * _e1146)) + _e6663.member_1) * _e5709), _e6659);
let _e6684 = select(-1e6f, (((((_e6663.member.member * _e6268) + (_e6663.member.member_1 * _e6269)) + (_e6663.member.member_2 * _e6270)) + _e6663.member_1) * _e5709), _e6659);
let _e6689 = global_1.member.member_18.member.member;
let _e6693 = -(_e6683);
let _e6696 = (_e6683 - _e6684);
let _e6697 = (_e6684 - _e6683);
let _e6699 = select(_e6697, _e6696, (_e6696 > _e6697));
let _e6702 = (select(_e6693, _e6683, (_e6683 > _e6693)) / select(1e-30f, _e6699, (_e6699 > 1e-30f)));
let _e6706 = select(0f, select(2f, _e6702, (_e6684 < 0f)), (_e6683 > 0f));
let _e6710 = select(2f, select(0f, _e6702, (_e6683 < 0f)), (_e6684 > 0f));
let _e6711 = (_e6683 > _e6649);
let _e6715 = ((_e6706 > _e6641) || ((_e6706 == _e6641) && _e6711));
let _e6716 = (_e6710 < _e6645);
let _e6717 = select(_e6641, _e6706, _e6715);
let _e6721 = select(_e6645, _e6710, _e6716);
let _e6725 = select(_e6649, _e6683, _e6711);
let _e6727 = select(_e6651, _e6684, (_e6684 > _e6651));
let _e6734 = global_1.member.member_19.member_1;
let _e6735 = (_e6734 != 0u);
let _e6739 = global_1.member.member_19.member;
let _e6759 = select(-1e6f, (((((_e6739.member.member * _e1152) + (_e6739.member.member_1 * _e1157)) + (_e6739.member.member_2 * _e1146)) + _e6739.member_1) * _e5709), _e6735);
let _e6760 = select(-1e6f, (((((_e6739.member.member * _e6268) + (_e6739.member.member_1 * _e6269)) + (_e6739.member.member_2 * _e6270)) + _e6739.member_1) * _e5709), _e6735);
let _e6765 = global_1.member.member_19.member.member;
let _e6769 = -(_e6759);
let _e6772 = (_e6759 - _e6760);
let _e6773 = (_e6760 - _e6759);
let _e6775 = select(_e6773, _e6772, (_e6772 > _e6773));
let _e6778 = (select(_e6769, _e6759, (_e6759 > _e6769)) / select(1e-30f, _e6775, (_e6775 > 1e-30f)));
let _e6782 = select(0f, select(2f, _e6778, (_e6760 < 0f)), (_e6759 > 0f));
let _e6786 = select(2f, select(0f, _e6778, (_e6759 < 0f)), (_e6760 > 0f));
let _e6787 = (_e6759 > _e6725);
let _e6791 = ((_e6782 > _e6717) || ((_e6782 == _e6717) && _e6787));
let _e6792 = (_e6786 < _e6721);
phi_16040_ = type_34(select(_e6717, _e6782, _e6791), vec3<f32>(select(select(select(select(_e6487, _e6537.member, _e6563), _e6613.member, _e6639), _e6689.member, _e6715), _e6765.member, _e6791), select(select(select(select(_e6488, _e6537.member_1, _e6563), _e6613.member_1, _e6639), _e6689.member_1, _e6715), _e6765.member_1, _e6791), select(select(select(select(_e6489, _e6537.member_2, _e6563), _e6613.member_2, _e6639), _e6689.member_2, _e6715), _e6765.member_2, _e6791)), select(_e6721, _e6786, _e6792), vec3<f32>(select(select(select(select(_e6492, _e6537.member, _e6564), _e6613.member, _e6640), _e6689.member, _e6716), _e6765.member, _e6792), select(select(select(select(_e6493, _e6537.member_1, _e6564), _e6613.member_1, _e6640), _e6689.member_1, _e6716), _e6765.member_1, _e6792), select(select(select(select(_e6494, _e6537.member_2, _e6564), _e6613.member_2, _e6640), _e6689.member_2, _e6716), _e6765.member_2, _e6792)), select(_e6725, _e6759, _e6787), select(_e6727, _e6760, (_e6760 > _e6727)), vec3<f32>(select(select(select(select(_e6498, _e6537.member, _e6559), _e6613.member, _e6635), _e6689.member, _e6711), _e6765.member, _e6787), select(select(select(select(_e6499, _e6537.member_1, _e6559), _e6613.member_1, _e6635), _e6689.member_1, _e6711), _e6765.member_1, _e6787), select(select(select(select(_e6500, _e6537.member_2, _e6559), _e6613.member_2, _e6635), _e6689.member_2, _e6711), _e6765.member_2, _e6787)));
}
let _e6812 = phi_16040_;
let _e6821 = global_1.member.member_7.member_4;
let _e6824 = (_e3040.member_3.x * _e3525.member_2);
let _e6826 = (_e3040.member_3.y * _e3525.member_2);
let _e6828 = (_e3040.member_3.z * _e3525.member_2);
let _e6829 = (0.5f * (_e6264 * select(1f, (2f * (1f - _e5697)), (_e5689 && _e5688))));
let _e6833 = (_e6247 + (_e6824 * _e6829));
let _e6834 = (_e6248 + (_e6826 * _e6829));
let _e6835 = (_e6249 + (_e6828 * _e6829));
let _e6837 = (2f * _e6261);
let _e6839 = ((_e6835 * _e6835) + (_e6837 * _e6828));
let _e6843 = (_e6835 + sqrt(select(0f, _e6839, (_e6839 > 0f))));
let _e6847 = (select(0.5f, _e6812.member_2, (_e6812.member_2 < 1f)) * (_e6837 / select(1e-6f, _e6843, (_e6843 > 1e-6f))));
let _e6851 = (_e6833 + (_e6824 * _e6847));
let _e6852 = (_e6834 + (_e6826 * _e6847));
let _e6853 = (_e6835 + (_e6828 * _e6847));
let _e6857 = (_e6821 * _e6821);
let _e6859 = (_e6853 * _e6853);
let _e6867 = (((_e6835 <= 0f) || (_e6839 <= 0f)) || ((_e6853 <= 0f) || (_e6859 <= (_e6857 * (((_e6851 * _e6851) + (_e6852 * _e6852)) + _e6859)))));
let _e6881 = (_e6247 + ((_e3040.member_4.x * _e3525.member_2) * _e6261));
let _e6882 = (_e6248 + ((_e3040.member_4.y * _e3525.member_2) * _e6261));
let _e6883 = (_e6249 + ((_e3040.member_4.z * _e3525.member_2) * _e6261));
let _e6885 = (_e6883 * _e6883);
let _e6894 = ((_e3320 & 1u) != 0u);
let _e6899 = (select(_e6867, ((_e6883 <= 0f) || (_e6885 <= (_e6857 * (((_e6881 * _e6881) + (_e6882 * _e6882)) + _e6885)))), _e6894) || (_e6246 && ((_e6222 && _e5689) || (_e5689 && (_e6249 <= 0f)))));
phi_16192_ = vec3<f32>(select(select(select(_e6851, _e6833, _e6867), _e6881, _e6894), _e233, _e6899), select(select(select(_e6852, _e6834, _e6867), _e6882, _e6894), _e244, _e6899), select(select(select(_e6853, _e6835, _e6867), _e6883, _e6894), _e255, _e6899));
phi_16193_ = select(1f, 0f, _e6899);
} else {
phi_16192_ = vec3<f32>(_e233, _e244, _e255);
phi_16193_ = 1f;
}
let _e6906 = phi_16192_;
let _e6908 = phi_16193_;
let _e6911 = (_e5101.member * _e6908);
global_4.member[_e190] = (_e201 * (_e5101.member_2.x * _e6911));
global_4.member[_e202] = (_e211 * (_e5101.member_2.y * _e6911));
global_4.member[_e213] = (_e222 * (_e5101.member_2.z * _e6911));
global_4.member[_e224] = _e6906.x;
global_4.member[_e235] = _e6906.y;
global_4.member[_e246] = _e6906.z;
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
